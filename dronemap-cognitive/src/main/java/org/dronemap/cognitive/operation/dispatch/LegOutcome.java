package org.dronemap.cognitive.operation.dispatch;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.dispatch.DispatchInput.CommandEnded;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg.IssuedCommand;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg.IssuedCommand.Purpose;
import org.dronemap.core.command.ArmingRetry;
import org.dronemap.core.command.Outcome;
import org.jspecify.annotations.Nullable;

/**
 * State of one drone of a dispatch after a command of it has ended.
 *
 * @param notice for whoever asked, as a sentence; null: nothing
 */
record LegOutcome(DispatchLeg leg, @Nullable String notice) {
    /** So long a drone may refuse to be armed: somebody waits, and another drone may be ready. */
    static final Duration LONGEST_ARMING = Duration.ofSeconds(20);

    private static final int MOST_TRIES = 3;
    /** What is heard of the vehicle takes a moment to say the same. */
    private static final Duration SETTLING = Duration.ofMillis(500);

    static LegOutcome of(DispatchLeg leg, IssuedCommand issued, CommandEnded ended) {
        String why = ended.outcome().reason();
        Instant at = ended.at();
        if (why == null) {
            return new LegOutcome(leg.succeeded(issued.purpose(), at.plus(SETTLING)), null);
        }
        if (issued.purpose() == Purpose.CLOUD_LOSS) {
            return new LegOutcome(
                    leg.succeeded(issued.purpose(), at),
                    leg.name() + " could not be told to come home when the cloud is lost (" + why
                            + "): it would then stay where it is until its battery is low.");
        }
        if (ended.outcome().kind() == Outcome.Kind.UNKNOWN) {
            return unknown(leg.failed(at.plus(ArmingRetry.PAUSE)), issued, why);
        }
        return isBeforeFlight(issued.purpose()) && ArmingRetry.mayPass(ended.outcome())
                ? notReady(leg.notReady(at, at.plus(ArmingRetry.PAUSE)), at, why)
                : failed(leg.failed(at.plus(ArmingRetry.PAUSE)), why);
    }

    private static boolean isBeforeFlight(Purpose purpose) {
        return switch (purpose) {
            case MODE, ARM -> true;
            case CLOUD_LOSS, TAKE_OFF, GO_TO, HOME, DISARM -> false;
        };
    }

    private static LegOutcome notReady(DispatchLeg leg, Instant at, String why) {
        Instant since = leg.attempts().refusedSince();
        boolean late = since != null && Duration.between(since, at).compareTo(LONGEST_ARMING) >= 0;
        return new LegOutcome(late ? leg.failing(leg.name() + " cannot be armed: " + why) : leg, null);
    }

    /** It may or may not have acted: what is seen of the drone decides how it goes on. */
    private static LegOutcome unknown(DispatchLeg leg, IssuedCommand issued, String why) {
        String words = "It is not known whether " + leg.name() + " was "
                + issued.purpose().done() + ": " + why;
        return new LegOutcome(leg.attempts().failed() >= MOST_TRIES ? leg.failing(words) : leg, words);
    }

    private static LegOutcome failed(DispatchLeg leg, String why) {
        boolean often = leg.attempts().failed() >= MOST_TRIES;
        return new LegOutcome(often ? leg.failing(leg.name() + " cannot come: " + why) : leg, null);
    }
}
