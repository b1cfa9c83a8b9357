package org.dronemap.core.cloud.outlook;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Forecast for a drone in the air: what happens when control ends, and how long its battery lasts.
 *
 * @param then a sentence
 * @param returnsAt when it is brought home unless somebody takes control; null: it does not come to that now
 * @param comesDown where it would be brought down then; null: nowhere, or not known
 * @param comesDownWords what that is called, as "home"; null: it would not be brought down, or circles at home, or that is not
 *     known; {@code then} says so
 * @param emptyAt when its battery is empty, as it has been used up so far; null: not known
 */
public record Outlook(
        State state,
        String then,
        @Nullable Instant returnsAt,
        @Nullable Geodetic comesDown,
        @Nullable String comesDownWords,
        @Nullable Instant emptyAt) {
    /**
     * State of an airborne drone's control: held, waiting for somebody, returning, without any remedy, or left alone.
     */
    public enum State {
        /** A user or an operation has it. */
        KEPT,
        /** Nobody has it; somebody may take it before it is brought home. */
        WAITS,
        /** Nobody has it, and it is on its way home or down. */
        RETURNS,
        /** Nobody has it, and nothing can be done for it. */
        HELPLESS,
        /** This cloud does nothing about it: a pilot or another station flies it, or the rules say so. */
        LEFT_ALONE
    }
}
