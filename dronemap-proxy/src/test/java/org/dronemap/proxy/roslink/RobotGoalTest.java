package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.drone.Capability;
import org.dronemap.proxy.fuzz.CommandSamples;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RobotGoalTest {
    @ParameterizedTest
    @EnumSource
    void hasAnAimForEachCommandThatARobotDeclares(RobotType type) {
        Set<Capability> can = new RobotTelemetryTranslator(type, null, event -> {}, () -> {})
                .capabilities()
                .commands();
        for (CommandKind kind : CommandKind.values()) {
            if (can.contains(kind.needs())) {
                for (Command command : CommandSamples.of(kind).toList()) {
                    assertThat(RobotGoal.of(command)).as(command.summary()).isPresent();
                }
            }
        }
    }
}
