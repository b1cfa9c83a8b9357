package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.fuzz.CommandSamples;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What an autopilot declares it does, and what it does not declare it turns into nothing else. */
class AutopilotsTest {
    private static final String NO_WAY = "This autopilot has no way to ";

    static Stream<Heartbeat> vehicles() {
        return IntStream.of(3, 12, 0)
                .boxed()
                .flatMap(autopilot -> IntStream.of(1, 2, 7, 10, 11, 12, 20, 99)
                        .mapToObj(type -> new Heartbeat(type, autopilot, 81, 0, 3, 3)));
    }

    @ParameterizedTest
    @MethodSource("vehicles")
    void hasAWayToDoWhatItDeclares(Heartbeat heartbeat) {
        Capabilities can = AutopilotAdapter.of(heartbeat).capabilities();
        for (CommandKind kind : CommandKind.values()) {
            boolean declared = can.commands().contains(kind.needs());
            CommandSamples.of(kind).forEach(command -> {
                String why = refusal(heartbeat, command);
                boolean none = why.startsWith(NO_WAY) || why.startsWith("The ways of this autopilot");
                assertThat(declared && none).as(command + ": " + why).isFalse();
            });
        }
    }

    /** Why it does not even begin; empty when it does. */
    private static String refusal(Heartbeat heartbeat, Command command) {
        Outcome outcome = new AutopilotTestBench(heartbeat).perform(command, 0.1);
        return outcome == null || outcome.reason() == null ? "" : outcome.reason();
    }

    @ParameterizedTest
    @MethodSource("vehicles")
    void saysEachSetpointThatItDeclares(Heartbeat heartbeat) {
        AutopilotAdapter autopilot = AutopilotAdapter.of(heartbeat);
        MavlinkTarget target = new MavlinkTarget(1, 1, message -> {});
        Stream.of(
                        new Setpoint.Velocity(Setpoint.Frame.VEHICLE, 1, 0, 0, Setpoint.Facing.ANY),
                        new Setpoint.Sticks(0.5, 0, 0, 0))
                .filter(setpoint -> autopilot.capabilities().commands().contains(setpoint.needs()))
                .forEach(setpoint -> assertThat(autopilot.steer(setpoint, target))
                        .as(setpoint.summary())
                        .isPresent());
    }

    @ParameterizedTest
    @MethodSource("vehicles")
    void hasTheModesThatItIsPutInto(Heartbeat heartbeat) {
        Capabilities can = AutopilotAdapter.of(heartbeat).capabilities();
        for (Steering steering : Steering.values()) {
            can.mode(steering).ifPresent(mode -> {
                assertThat(can.modes()).contains(mode);
                assertThat(can.steering(mode)).contains(steering);
            });
        }
    }
}
