package org.dronemap.core.separation;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Memory of one drone that gives way.
 *
 * @param give what its operation is shown
 * @param since when it began to give way
 * @param busyUntil it is on a step aside until then at most
 * @param stood it was seen standing since it was told to
 * @param aside where it steps aside to; null: it stands
 */
public record Yielding(GiveWay give, Instant since, Instant busyUntil, boolean stood, Command.@Nullable GoTo aside) {
    /** From an order to step aside until it moves. */
    private static final Duration UNTIL_MOVING = Duration.ofMillis(1_500);
    /** From an order to stand until it shows. */
    private static final Duration UNTIL_SEEN = Duration.ofSeconds(3);

    static Yielding began(GiveWay give, Instant busyUntil, Command.@Nullable GoTo aside) {
        return new Yielding(give, give.since(), busyUntil, false, aside);
    }

    /** As it was before a restart: told, and long since standing. */
    public static Yielding restored(GiveWay give) {
        return new Yielding(give, give.since(), give.since(), true, null);
    }

    DroneId to() {
        return give.to();
    }

    boolean isBusy(Instant now) {
        return now.isBefore(busyUntil);
    }

    /** Told in flight: it is not under way to where its operation had it go. */
    boolean isOrdered() {
        return give.manner() != GiveWay.Manner.WAIT;
    }

    Yielding clear(boolean now) {
        return give.clear() == now ? this : new Yielding(give.withClear(now), since, busyUntil, stood, aside);
    }

    Yielding seenStanding() {
        return stood ? this : new Yielding(give, since, busyUntil, true, aside);
    }

    /** It gives way to another one, or in another way, from now on. */
    Yielding again(GiveWay next, Instant until, Command.@Nullable GoTo there) {
        return new Yielding(next, since, until, stood && next.manner() != GiveWay.Manner.WAIT, there);
    }

    /** The order did not show in time: it was lost, or somebody has it go on. */
    boolean isUnheeded(Instant now) {
        return !stood && Duration.between(give.since(), now).compareTo(UNTIL_SEEN) > 0;
    }

    /** It was told to step aside so long ago that it moves by now. */
    boolean shouldMove(Instant now) {
        return Duration.between(give.since(), now).compareTo(UNTIL_MOVING) > 0;
    }

    Duration lasting(Instant now) {
        return Duration.between(since, now);
    }
}
