package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.ws.drone.DroneEventView;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/** One event of any drone with its number, as clients see it; a null member is unknown or does not apply. */
@Schema(name = "NumberedEvent")
record NumberedEventView(
        @Schema(description = "Rises from event to event, with numbers left out; below 2^53")
        long number,

        @Schema(description = "Id of the drone") String drone,
        Instant at,

        @EnumValues(HistoryEvent.Kind.class) String kind,

        String text,
        @EnumValues(Severity.class) @Nullable String severity,
        @Nullable String by,
        @Schema(description = "Id of the command") @Nullable String command,

        @EnumValues(Outcome.Kind.class) @Nullable String result,

        @Nullable String reason) {

    static NumberedEventView of(long number, HistoryEvent event) {
        DroneEventView view = DroneEventView.of(event);
        return new NumberedEventView(
                number,
                event.drone().value(),
                view.at(),
                view.kind(),
                view.text(),
                view.severity(),
                view.by(),
                view.command(),
                view.result(),
                view.reason());
    }
}
