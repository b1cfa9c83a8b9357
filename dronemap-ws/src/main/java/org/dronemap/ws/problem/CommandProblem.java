package org.dronemap.ws.problem;

import java.util.Arrays;
import java.util.List;
import org.dronemap.core.command.OutcomeCode;

/** Problem code of a refused command or setpoint: the same code that stands in the outcome of the command. */
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
