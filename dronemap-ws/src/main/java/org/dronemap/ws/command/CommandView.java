package org.dronemap.ws.command;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** A command as clients see it. */
@Schema(name = "CommandView")
public record CommandView(
        String id,
        String drone,
        String by,
        String face,
        @EnumValues(CommandKind.class) String type,
        String summary,
        Instant at,
        @EnumValues(CommandPhase.class) String phase,
        @Nullable OutcomeView outcome,
        @Nullable Instant finishedAt,
        @Nullable ProgressView progress,

        @Schema(description = "Of the control that it was given under; null: of none") @Nullable
        Long epoch,

        @Schema(description = "What may be a slip of the hand, such as a far place; told once, to who gave the command")
        List<String> warnings) {

    /** Outcome of a command; {@code by}: gate or vehicle, whichever refused it. */
    @Schema(name = "CommandOutcomeView")
    public record OutcomeView(
            @EnumValues(Outcome.Kind.class) String result,

            @Schema(allowableValues = {"gate", "vehicle"}) @Nullable
            String by,

            @Nullable String reason,

            @Schema(description = "Why, for programs; docs/problems.md lists them") @Nullable
            String code) {}

    /** Steps done of steps in all. */
    @Schema(name = "CommandProgressView")
    public record ProgressView(int done, int total) {}

    public static CommandView of(CommandRecord command) {
        CommandRecord.Progress progress = command.progress();
        Outcome outcome = command.outcome();
        Instant finishedAt = command.finishedAt();
        return new CommandView(
                command.id().value(),
                command.drone().value(),
                command.by(),
                command.face(),
                WireNames.lowerFirst(command.type()),
                command.summary(),
                command.at().truncatedTo(ChronoUnit.MILLIS),
                WireNames.camel(command.phase()),
                outcome == null ? null : outcomeView(outcome),
                finishedAt == null ? null : finishedAt.truncatedTo(ChronoUnit.MILLIS),
                progress == null ? null : new ProgressView(progress.done(), progress.total()),
                command.epoch(),
                List.of());
    }

    public CommandView warned(List<String> sentences) {
        return new CommandView(
                id, drone, by, face, type, summary, at, phase, outcome, finishedAt, progress, epoch, sentences);
    }

    /** Without the words that people wrote; {@code by} stands for who gave it. */
    CommandView withoutNames(String by) {
        OutcomeView bare =
                outcome == null ? null : new OutcomeView(outcome.result(), outcome.by(), null, outcome.code());
        return new CommandView(
                id, drone, by, face, type, summary, at, phase, bare, finishedAt, progress, epoch, List.of());
    }

    /** The one naming of outcomes for all faces. */
    public static OutcomeView outcomeView(Outcome outcome) {
        OutcomeCode code = outcome.code();
        return new OutcomeView(
                outcome.kind().word(), outcome.by(), outcome.reason(), code == null ? null : code.word());
    }
}
