package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Each autopilot says of a mode in which it refuses to be armed which one lets it: nobody above it knows their names. */
class ArmingModesTest {
    private static final int FIXED_WING = 1;
    private static final int QUADROTOR = 2;
    private static final int ROVER = 10;

    static Stream<Arguments> autopilots() {
        return Stream.of(
                Arguments.of("ArduCopter", new ArduPilotAdapter(QUADROTOR).capabilities()),
                Arguments.of("ArduPlane", new ArduPilotAdapter(FIXED_WING).capabilities()),
                Arguments.of("ArduRover", new ArduPilotAdapter(ROVER).capabilities()),
                Arguments.of("PX4", new Px4Adapter(QUADROTOR).capabilities()));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("autopilots")
    void afterItsWayHomeThereIsAModeInWhichItIsArmedAndWaitsForOrders(String name, Capabilities can) {
        assertThat(can.armingMode("RTL")).isPresent();
        assertThat(can.arming()).allSatisfy((refusing, arms) -> {
            assertThat(can.modes()).contains(refusing, arms);
            assertThat(can.arming()).doesNotContainKey(arms);
            assertThat(can.steering(arms)).contains(Steering.ORDERS);
        });
        assertThat(can.modes().stream().filter(mode -> can.steering(mode).equals(Optional.of(Steering.SAFETY))))
                .as("every way home or down of %s", name)
                .allMatch(mode -> can.armingMode(mode).isPresent());
    }
}
