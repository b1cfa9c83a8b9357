package org.dronemap.core.lease;

import org.jspecify.annotations.Nullable;

/**
 * A change of who controls a drone, such as taken, requested, released or expired.
 *
 * @param by who did it, or whom it befell
 * @param other who had it before, or who gets it; null where there is nobody else
 * @param reason as given; null: none
 */
public record ControlChange(
        Kind kind,
        LeaseHolder by,
        @Nullable LeaseHolder other,
        @Nullable String reason) {
    public enum Kind {
        TAKEN,
        REQUESTED,
        REFUSED,
        HANDED_OVER,
        TAKEN_OVER,
        RELEASED,
        /** Ended because its holder was idle. */
        EXPIRED,
        /** An explicit holder fell silent. */
        LOST,
        /** Nobody took it after that in time: the drone shall return. */
        RETURN_DUE,
        PILOT_ACTED,
        PILOT_LEFT,
        /** The holder may command no more. */
        EXPELLED
    }
}
