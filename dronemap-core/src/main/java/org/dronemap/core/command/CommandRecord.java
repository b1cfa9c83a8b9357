package org.dronemap.core.command;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Record of a command: who gave it, what it asks for, and its progress and outcome; immutable.
 *
 * @param face the way in: page, rest, soap, stream
 * @param summary the phrase for people
 * @param progress null for commands without countable steps
 * @param epoch of the control that it was given under; null: of none
 * @param outcome null exactly as long as {@code phase} is not DONE, as is {@code finishedAt}
 * @param content the {@link CommandDigest} of what was asked for; null: written down before there was one
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
        @Nullable Long epoch,
        @Nullable String content) {
    /** Steps done of steps in all. */
    public record Progress(int done, int total) {}

    /** Without a digest of what was asked for. */
    public CommandRecord(
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
        this(id, drone, by, face, type, summary, at, phase, progress, outcome, finishedAt, epoch, null);
    }

    /** Whether that user asked just this; {@code command} is what was made of what was {@code asked}. */
    public boolean isOf(String user, String account, DroneId wanted, Command command, Command asked) {
        boolean alike =
                content == null ? summary.equals(command.summary()) : content.equals(CommandDigest.of(account, asked));
        return by.equals(user)
                && drone.equals(wanted)
                && type.equals(command.kind().word())
                && alike;
    }

    public CommandRecord withEpoch(long given) {
        return new CommandRecord(
                id, drone, by, face, type, summary, at, phase, progress, outcome, finishedAt, given, content);
    }

    public CommandRecord withPhase(CommandPhase next) {
        return new CommandRecord(
                id, drone, by, face, type, summary, at, next, progress, outcome, finishedAt, epoch, content);
    }

    public CommandRecord withProgress(Progress next) {
        return new CommandRecord(
                id, drone, by, face, type, summary, at, phase, next, outcome, finishedAt, epoch, content);
    }

    public CommandRecord ended(Outcome how, Instant when) {
        return new CommandRecord(
                id, drone, by, face, type, summary, at, CommandPhase.DONE, progress, how, when, epoch, content);
    }
}
