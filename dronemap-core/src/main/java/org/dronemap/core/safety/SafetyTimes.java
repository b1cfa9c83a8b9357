package org.dronemap.core.safety;

import java.time.Duration;

/**
 * Timeouts that must fit each other when vehicle, user or cloud falls silent; see docs/times.md. The next one begins
 * only after the one before is over, or nobody would know who acts.
 */
public final class SafetyTimes {
    /** Since a vehicle heard the cloud last, until it comes home by itself: longer than the server takes to be back. */
    public static final Duration VEHICLE_RETURNS = Duration.ofSeconds(20);
    /** A silent vehicle that is led, or waits, may go on for so long: what lies ahead of it is kept for it. */
    public static final Duration CORRIDOR_KEPT = VEHICLE_RETURNS.plusSeconds(5);

    /** From when a vehicle is lost until others get what lies ahead of it, where it comes home by itself. */
    public static final Duration CORRIDOR_FREED = CORRIDOR_KEPT.plusSeconds(10);

    /** No battery lasts longer for one that stands in the air, where its fail-safe does not bring it home. */
    public static final Duration LONGEST_HOVER = Duration.ofMinutes(45);

    /** Whoever stops a silent vehicle on its mission, its own fail-safe among them, does so within that time. */
    public static final Duration STOPPED_WITHIN = Duration.ofSeconds(6);

    private SafetyTimes() {}
}
