package org.dronemap.core.command;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * A command with who asked, and how far it is; immutable, a newer one replaces it.
 *
 * @param face the way in: page, rest, soap, stream
 * @param summary the phrase for people
 * @param progress null for commands without countable steps
 * @param epoch of the control that it was given under; null: of none
 * @param outcome null exactly as long as {@code phase} is not DONE, as is {@code finishedAt}
 */
public record CommandRecord(
        CommandId id,
        DroneId drone,
        String by,
        String face,
        String type,
        String summary,
        Instant at,
        CommandPhase phase,
        @Nullable Progress progress,
        @Nullable Outcome outcome,
        @Nullable Instant finishedAt,
        @Nullable Long epoch) {
    /** Steps done of steps in all. */
    public record Progress(int done, int total) {}

    public CommandRecord withEpoch(long given) {
        return new CommandRecord(id, drone, by, face, type, summary, at, phase, progress, outcome, finishedAt, given);
    }

    public CommandRecord withPhase(CommandPhase next) {
        return new CommandRecord(id, drone, by, face, type, summary, at, next, progress, outcome, finishedAt, epoch);
    }

    public CommandRecord withProgress(Progress next) {
        return new CommandRecord(id, drone, by, face, type, summary, at, phase, next, outcome, finishedAt, epoch);
    }

    public CommandRecord ended(Outcome how, Instant when) {
        return new CommandRecord(id, drone, by, face, type, summary, at, CommandPhase.DONE, progress, how, when, epoch);
    }
}
