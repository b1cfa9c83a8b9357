package org.dronemap.core.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class CommandKindTest {
    /** Whoever judges these looks into the command, as the record that each of them names. */
    @Test
    void hasOneRecordWhereTheRulesLookIntoIt() {
        Map<ImmediateEffect, List<CommandKind>> movements = by(CommandKind::movement, ImmediateEffect.class);
        Map<DeferredEffect, List<CommandKind>> changes = by(CommandKind::laterChange, DeferredEffect.class);

        assertThat(movements)
                .containsEntry(ImmediateEffect.CLIMBS, List.of(CommandKind.TAKE_OFF))
                .containsEntry(ImmediateEffect.GOES, List.of(CommandKind.GO_TO))
                .containsEntry(ImmediateEffect.CHANGES_SPEED, List.of(CommandKind.CHANGE_SPEED))
                .containsEntry(ImmediateEffect.TAKES_MISSION, List.of(CommandKind.UPLOAD_MISSION))
                .containsEntry(ImmediateEffect.CHANGES_MODE, List.of(CommandKind.SET_MODE));
        assertThat(changes)
                .containsEntry(DeferredEffect.HOME, List.of(CommandKind.SET_HOME))
                .containsEntry(DeferredEffect.RALLY_POINTS, List.of(CommandKind.SET_RALLY_POINTS))
                .containsEntry(DeferredEffect.MODE, List.of(CommandKind.SET_MODE));
    }

    /** What moves a drone is what others have to give way to, and what only reads moves nothing. */
    @Test
    void saysTheSameOfAMoveInEachOfItsAnswers() {
        assertThat(CommandKind.values()).allSatisfy(kind -> {
            boolean flies = kind.contention() == Contention.FLIGHT;
            // How fast it goes competes with no order where to go.
            boolean moves = kind.movement() != ImmediateEffect.NONE && kind.movement() != ImmediateEffect.CHANGES_SPEED;
            assertThat(flies && !moves)
                    .as(kind + " competes for the flight and moves nothing")
                    .isFalse();
            assertThat(moves && kind.purpose() == CommandKind.Purpose.READ)
                    .as(kind + " moves what it only asks")
                    .isFalse();
            assertThat(moves && !flies)
                    .as(kind + " moves without competing for the flight")
                    .isEqualTo(moves && kind.contention() == Contention.TRANSFER);
            if (kind.purpose() == CommandKind.Purpose.SAFETY || kind.purpose() == CommandKind.Purpose.PAUSE) {
                assertThat(kind.movement()).isIn(ImmediateEffect.STANDS, ImmediateEffect.COMES_DOWN);
            }
        });
    }

    private static <E extends Enum<E>> Map<E, List<CommandKind>> by(Function<CommandKind, E> answer, Class<E> type) {
        return Stream.of(CommandKind.values())
                .collect(Collectors.groupingBy(answer, () -> new EnumMap<>(type), Collectors.toList()));
    }
}
