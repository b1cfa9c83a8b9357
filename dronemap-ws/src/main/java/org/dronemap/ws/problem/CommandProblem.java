package org.dronemap.ws.problem;

import java.util.Arrays;
import java.util.List;
import org.dronemap.core.command.OutcomeCode;

/** The code of a command or a setpoint that was refused, as commands have it: what the record of a command says and what a caller is told are one. */
public record CommandProblem(OutcomeCode outcome) implements ProblemCode {
    static List<CommandProblem> values() {
        return Arrays.stream(OutcomeCode.values()).map(CommandProblem::new).toList();
    }

    @Override
    public ProblemCatalogueEntry entry() {
        ProblemCatalogueEntry entry = ProblemCatalogueEntry.of(
                        outcome.word(), RejectionKind.CONFLICT, outcome.meaning(), outcome.example())
                .with(ProblemParameter.DRONE);
        return outcome == OutcomeCode.CONTROL_HELD || outcome == OutcomeCode.CONTROL_ENDED
                ? entry.maybe(ProblemParameter.COMMAND, ProblemParameter.HOLDER, ProblemParameter.HELD_SINCE)
                : entry.maybe(ProblemParameter.COMMAND);
    }
}
