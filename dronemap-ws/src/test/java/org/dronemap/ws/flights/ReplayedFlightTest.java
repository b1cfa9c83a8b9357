package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.recording.ReplayService;
import org.dronemap.ws.recording.ReplayView;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Recordings of real vehicles, where they are at hand, played at ten times their speed. */
class ReplayedFlightTest {
    private static final List<String> MODES = List.of("MANUAL", "STABILIZE", "ALT_HOLD", "POSHOLD", "SURFACE", "ACRO");
    private static final Duration LONGEST = Duration.ofMinutes(10);

    @ParameterizedTest
    @CsvSource({
        "ardusub_small.tlog, 35912, true",
        "mavlinkserver_00025.tlog, 30439, false",
        "ardusub_pymavlink_bug_2023-04-18.tlog, 50136, false"
    })
    void aRecordingShowsItsVehicleAndLosesNoGoodMessage(String name, long goodMessages, boolean hasPosition)
            throws IOException {
        String folder = System.getenv("DRONEMAP_TEST_DATA");
        Assumptions.assumeTrue(folder != null, "DRONEMAP_TEST_DATA is not set; recordings are not played");
        try (Laboratory lab = new Laboratory(1);
                InputStream tlog = Files.newInputStream(Path.of(folder, "tlogs", name))) {
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            ReplayService replays = lab.server().office().replays();
            String replay = replays.start(ann.principal(), name, 10.0, tlog).id();
            DroneId drone = lab.until(
                    "its drone is listed",
                    Duration.ofSeconds(30),
                    () -> replays.replay(ann.principal(), replay).drones().stream()
                            .findFirst()
                            .map(DroneId::new));
            lab.until("mode and battery are shown", Duration.ofSeconds(20), () -> shows(lab, drone));
            checkSubmarine(state(lab, drone));
            assertThat(ann.refusal(drone, CommandRequests.arm())).contains("recording");

            ReplayView done = lab.until(
                    "it was played to its end",
                    LONGEST,
                    () -> Optional.of(replays.replay(ann.principal(), replay))
                            .filter(now -> now.state().equals("finished")));
            assertThat(done.goodMessages()).isEqualTo(goodMessages);
            assertThat(done.drones()).as("other components make no drone").hasSize(1);
            DroneState last = state(lab, drone);
            assertThat(last.position() != null && last.position().point() != null)
                    .isEqualTo(hasPosition);
            lab.until(
                    "it is called ended, not lost",
                    Duration.ofSeconds(2),
                    () -> state(lab, drone).link().state() == LinkState.ENDED);
        }
    }

    private static DroneState state(Laboratory lab, DroneId drone) {
        return lab.server().house().cloud().drone(drone).orElseThrow();
    }

    private static boolean shows(Laboratory lab, DroneId drone) {
        DroneState now = state(lab, drone);
        return now.mode() != null && now.battery() != null && now.battery().volts() != null;
    }

    private static void checkSubmarine(DroneState drone) {
        assertThat(drone.replay()).isTrue();
        assertThat(drone.identification().kind()).isEqualTo(VehicleKind.SUBMARINE);
        assertThat(drone.identification().autopilot()).isEqualTo("ArduPilot");
        assertThat(drone.identification().vehicle()).isEqualTo("ArduSub");
        assertThat(drone.mode()).isIn(MODES);
    }
}
