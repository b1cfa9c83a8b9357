package org.dronemap.core.command;

import java.time.Duration;
import java.util.EnumSet;
import java.util.Set;

/**
 * Knows which refusals to be armed, or to take the mode for it, may pass by themselves, and for how long they are
 * waited for: an autopilot finds its position up to a minute after it was switched on, and refuses till then.
 */
public final class ArmingRetry {
    /** From the first refusal on. */
    public static final Duration LONGEST = Duration.ofMinutes(2);

    public static final Duration PAUSE = Duration.ofSeconds(3);

    private static final Set<OutcomeCode> PASSING = EnumSet.of(
            OutcomeCode.VEHICLE_BUSY,
            OutcomeCode.VEHICLE_DENIED,
            OutcomeCode.VEHICLE_FAILED,
            OutcomeCode.VEHICLE_REFUSED,
            OutcomeCode.COMMAND_FAILED,
            OutcomeCode.CAPABILITIES_UNKNOWN,
            OutcomeCode.COMMAND_UNDER_WAY,
            OutcomeCode.TRANSFER_UNDER_WAY);

    private ArmingRetry() {}

    /** Whether the answer may be another one in a moment. */
    public static boolean mayPass(Outcome outcome) {
        OutcomeCode code = outcome.code();
        return code != null && PASSING.contains(code);
    }
}
