package org.dronemap.ws.run;

import com.fasterxml.jackson.annotation.JsonRawValue;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.Semaphore;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.JournalReplay;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Reads the journals of mission runs and replays their decisions. Any thread. */
public final class RunJournalService {
    private static final int MOST = 200;

    private final RunService runs;
    private final Operations operations;
    private final OperationKind<RunState, RunInput> kind;
    /** Long journals take a while to be decided on again: one at a time. */
    private final Semaphore replaying = new Semaphore(1);

    /** A part of a journal. */
    @Schema(name = "RunJournalView", description = "What befell a mission run, in order.")
    public record JournalView(
            List<EntryView> entries,

            @Schema(description = "The number to go on from; null: this was the last part") @Nullable
            Long next) {}

    /** One entry. */
    @Schema(name = "JournalEntryView")
    public record EntryView(
            @Schema(description = "From 0") long number,
            Instant at,

            @Schema(
                    description = "What befell it, as it was written down; of the entry 0 the state that it began with",
                    type = "object")
            @JsonRawValue
            String input,

            @Schema(
                    description =
                            "What it decided: its actions, why, and the SHA-256 of the state that followed; null of the"
                                    + " entry 0",
                    type = "object",
                    nullable = true)
            @JsonRawValue
            @Nullable
            String decision) {}

    /** Result of replaying a run's journal: whether it gives the decisions recorded, and the first that differs. */
    @Schema(name = "RunReplayView", description = "Whether everything is decided again as it was written down.")
    public record JournalReplayView(
            boolean same,

            @Schema(description = "How many entries were looked at")
            long entries,

            @Schema(description = "The first entry that is decided on otherwise") @Nullable
            Long number,

            @Schema(description = "What was written down") @Nullable
            String written,

            @Schema(description = "What is decided now, or why nothing is") @Nullable
            String decided) {}

    public RunJournalService(RunService runs, Operations operations, OperationKind<RunState, RunInput> kind) {
        this.runs = runs;
        this.operations = operations;
        this.kind = kind;
    }

    /** From that number on, as many as are given at once. */
    public JournalView journal(Principal principal, String id, long from) {
        OperationId run = known(principal, id);
        if (from < 0) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE, "from", "0 or more", from, ProblemParameter.LEAST.is(0));
        }
        List<JournalEntry> entries = operations.journal(run, from, MOST);
        return new JournalView(
                entries.stream().map(RunJournalService::view).toList(), entries.size() < MOST ? null : from + MOST);
    }

    private static EntryView view(JournalEntry entry) {
        return new EntryView(
                entry.number(), entry.at(), entry.input(), entry.decision().isEmpty() ? null : entry.decision());
    }

    public JournalReplayView replay(Principal principal, String id) {
        OperationId run = known(principal, id);
        if (!replaying.tryAcquire()) {
            throw Rejection.of(
                    ServerProblem.SERVER_BUSY,
                    "Another journal is being replayed; try again in a minute.",
                    ProblemParameter.WHAT.is("replays of journals"));
        }
        try {
            JournalReplay<RunState, RunInput> replay = new JournalReplay<>(kind);
            List<JournalEntry> part;
            do {
                part = operations.journal(run, replay.count(), MOST);
                replay.replay(part);
            } while (part.size() == MOST && replay.difference().isEmpty());
            return replay.difference()
                    .map(other -> new JournalReplayView(
                            false, replay.count(), other.number(), other.written(), other.decided()))
                    .orElseGet(() -> new JournalReplayView(true, replay.count(), null, null, null));
        } finally {
            replaying.release();
        }
    }

    private OperationId known(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        return runs.find(principal, id).saved().id();
    }
}
