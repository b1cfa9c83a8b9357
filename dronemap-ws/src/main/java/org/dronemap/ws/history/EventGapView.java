package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventSeries;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.reading.WireTimes;
import org.jspecify.annotations.Nullable;

/** A time of which events are missing, with the reason, as clients see it. */
@Schema(name = "EventGap")
record EventGapView(
        @Schema(description = "Events with higher numbers come after the gap; 0: all do")
        long after,

        @EnumValues(Cause.class) String cause,

        @Schema(description = "Since when events are missing; null: not known") @Nullable
        Instant from,

        @Schema(description = "Until when; null: not known") @Nullable
        Instant until,

        @Schema(
                description = "How many events are missing, those of drones that are not shown to you included; told to"
                        + " those who run the server; null: not known, or not told")
        @Nullable
        Long count,

        @Schema(description = "The reason, as a sentence") String text) {

    /** Causes of gaps: those that are stored, and those that show when somebody asks. */
    enum Cause {
        NOT_WRITTEN("The server could not store all events of this time."),
        SERVER_ENDED("The server ended without storing what it had in memory, and was started anew."),
        RESTORED("The server was restored from a backup; what happened after that is not in it."),
        EXPIRED("The server has dropped events of this time, for they are no longer kept."),
        OTHER_SERIES("The events before are of another store; these are all that are kept here.");

        private final String sentence;

        Cause(String sentence) {
            this.sentence = sentence;
        }
    }

    private static EventGapView of(
            long after, Cause cause, @Nullable Instant from, @Nullable Instant until, @Nullable Long count) {
        return new EventGapView(
                after,
                WireNames.camel(cause),
                WireTimes.shownOrNull(from),
                WireTimes.shownOrNull(until),
                count,
                cause.sentence);
    }

    static EventGapView of(EventGap gap, boolean counted) {
        Cause cause = switch (gap.cause()) {
            case NOT_WRITTEN -> Cause.NOT_WRITTEN;
            case SERVER_ENDED -> Cause.SERVER_ENDED;
            case RESTORED -> Cause.RESTORED;
        };
        return of(gap.number(), cause, gap.from(), gap.until(), counted ? gap.lost() : null);
    }

    static EventGapView expired(long after, EventSeries series) {
        return of(after, Cause.EXPIRED, null, series.expiredBefore(), null);
    }

    static EventGapView otherSeries() {
        return of(0, Cause.OTHER_SERIES, null, null, null);
    }
}
