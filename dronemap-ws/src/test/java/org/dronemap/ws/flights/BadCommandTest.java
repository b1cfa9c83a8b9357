package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTap;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.problem.InvalidInput;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Bad input: a sentence that helps, and nothing on the wire. */
class BadCommandTest {
    /** Asking for messages and their rates, which goes on by itself. */
    private static final Set<Integer> BY_ITSELF = Set.of(511, 512, 519, 520);

    private final Laboratory lab = new Laboratory(1);
    private final LabDrone copter = lab.copter();
    private final LinkTap tap = copter.wire().tap();

    @AfterEach
    void nothingWentToTheVehicle() {
        try (lab) {
            assertQuiet();
        }
    }

    private void assertQuiet() {
        lab.goOn(Duration.ofSeconds(3));
        assertThat(Stream.concat(
                        tap.told(CommandLong.ID, CommandLong::decode).stream().map(CommandLong::command),
                        tap.told(CommandInt.ID, CommandInt::decode).stream().map(CommandInt::command)))
                .allMatch(BY_ITSELF::contains);
        assertThat(tap.told(MissionCount.ID, MissionCount::decode)).isEmpty();
        assertThat(tap.told(MissionItemInt.ID, MissionItemInt::decode)).isEmpty();
        assertThat(copter.craft().armed()).isFalse();
    }

    private static MissionItemRequest waypoint(double latitude, double longitude, @Nullable Double altitude) {
        return new MissionItemRequest.Waypoint(latitude, longitude, altitude, null, null);
    }

    static Stream<Arguments> badValues() {
        return Stream.of(
                Arguments.of(
                        CommandRequests.uploadMission(List.of(waypoint(47.4, 8.5, 20.0), waypoint(47, 8, null))),
                        "items[1].altitude",
                        "altitude"),
                Arguments.of(CommandRequests.goTo(95.0, 8.0, 20.0), "latitude", "-90 to 90"),
                Arguments.of(CommandRequests.goTo(47.0, 181.0, 20.0), "longitude", "-180 to 180"),
                Arguments.of(CommandRequests.takeOff(0.0), "altitude", "1 to 500"),
                Arguments.of(CommandRequests.takeOff(null), "altitude", "altitude"),
                Arguments.of(CommandRequests.uploadMission(List.of()), "items", "1 to 500"));
    }

    @ParameterizedTest
    @MethodSource("badValues")
    void badValuesNameTheFieldAndTheRange(CommandRequest command, String field, String words) {
        Pilot ann = lab.pilot("ann", Role.OPERATOR);

        InvalidInput refused = catchThrowableOfType(InvalidInput.class, () -> ann.give(copter, command));

        assertThat(refused.field()).isEqualTo(field);
        assertThat(refused.sentence() + refused.allowed()).contains(words);
    }

    @Test
    void aViewerMayLookButNotArm() {
        Pilot vera = lab.pilot("vera", Role.VIEWER);
        assertThat(lab.server().drones().drones(vera.principal())).hasSize(1);

        assertThat(vera.refusal(copter, CommandRequests.arm())).contains("operator");
    }
}
