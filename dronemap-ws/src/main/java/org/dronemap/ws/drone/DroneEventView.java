package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.reading.WireTimes;
import org.jspecify.annotations.Nullable;

/** One event in the history of a drone, as clients see it; a null member is unknown or does not apply. */
@Schema(name = "EventView")
public record DroneEventView(
        Instant at,

        @EnumValues(HistoryEvent.Kind.class) String kind,

        String text,
        @EnumValues(Severity.class) @Nullable String severity,
        @Nullable String by,
        @Schema(description = "Id of the command") @Nullable String command,

        @EnumValues(Outcome.Kind.class) @Nullable String result,

        @Nullable String reason) {

    /** Oldest first; {@code more}: there are more than that. */
    @Schema(name = "Events")
    public record Events(String drone, Instant from, Instant until, List<DroneEventView> events, boolean more) {}

    public static DroneEventView of(HistoryEvent event) {
        return new DroneEventView(
                WireTimes.shown(event.at()),
                WireNames.camel(event.kind()),
                event.text(),
                event.severity() == null ? null : WireNames.camel(event.severity()),
                event.by(),
                event.command(),
                event.result(),
                event.reason());
    }
}
