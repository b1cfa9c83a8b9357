package org.dronemap.ws.reading;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Reads times that clients wrote, and rounds times as clients see them. */
public final class WireTimes {
    private WireTimes() {}

    /** Null where nothing was given. */
    public static @Nullable Instant read(String field, @Nullable String text) {
        if (text == null || text.isBlank()) {
            return null;
        }
        try {
            return Instant.parse(text.strip());
        } catch (DateTimeException e) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED, field, "a time such as 2026-03-04T05:06:07Z", "\"" + text + "\"");
        }
    }

    public static Instant shown(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS);
    }

    public static @Nullable Instant shownOrNull(@Nullable Instant time) {
        return time == null ? null : shown(time);
    }
}
