package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;

/** Events of all drones that a client sees after a place in their series, as clients see them. */
@Schema(name = "FollowedEvents")
record FollowedEventsView(
        @Schema(description = "By their numbers") List<NumberedEventView> events,

        @Schema(description = "Where events are missing, in order")
        List<EventGapView> gaps,

        @Schema(description = "To go on from, as after: a text that only the server reads")
        String next) {}
