package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.ScriptedPeer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Every mode that pymavlink knows of an autopilot has the same name here and can be set by it. */
class ModesTest {
    /** Whether it is still what pymavlink says is an end-to-end test's to say. */
    private static final Path TABLE =
            Path.of("../dronemap-proxy/src/test/resources/org/dronemap/proxy/mavlink/translate/modes.txt");

    private static Map<Long, String> modes(int autopilot, int type) throws IOException {
        Map<Long, String> modes = new LinkedHashMap<>();
        for (String line : Files.readAllLines(TABLE)) {
            String[] words = line.split(" ", -1);
            if (words[0].equals(String.valueOf(autopilot)) && words[1].equals(String.valueOf(type))) {
                modes.put(Long.valueOf(words[2]), words[3]);
            }
        }
        return modes;
    }

    @ParameterizedTest
    @CsvSource({"ArduCopter,3,2", "ArduPlane,3,1", "ArduRover,3,10", "ArduSub,3,12", "PX4,12,2"})
    void everyModeHasPymavlinksNameAndIsSetByIt(String vehicle, int autopilot, int type) throws IOException {
        Map<Long, String> modes = modes(autopilot, type);
        assertThat(modes).hasSizeGreaterThan(8);
        try (Laboratory lab = new Laboratory(1)) {
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            ScriptedPeer peer = lab.peer(1, ScriptedPeer.Kind.vehicle(type, autopilot), ScriptedPeer.OBEDIENT);
            lab.until(
                    "the peer is listed as " + vehicle,
                    Duration.ofSeconds(30),
                    () -> peer.known()
                            .filter(state -> state.identification().vehicle().startsWith(vehicle))
                            .isPresent());

            modes.forEach((number, name) -> {
                peer.isIn(number);
                lab.until(
                        number + " is shown as " + name,
                        Duration.ofSeconds(3),
                        () -> name.equals(peer.state().mode()));
            });
            List<Map.Entry<Long, String>> backwards = new ArrayList<>(modes.entrySet());
            Collections.reverse(backwards);
            for (Map.Entry<Long, String> mode : backwards) {
                ann.does(peer, CommandRequests.setMode(mode.getValue()));
                assertThat(peer.customMode()).as(mode.getValue()).isEqualTo(mode.getKey());
            }
        }
    }
}
