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
 * @param clearSince since when it may go on; null: it may not
 * @param mayGoUntil it might go on when it was told anew, and its operation may have sent it on in that moment: then it
 *     shows by then; null: it might not
 */
public record Yielding(
        GiveWay give,
        Instant since,
        Instant busyUntil,
        boolean stood,
        Command.@Nullable GoTo aside,
        @Nullable Instant clearSince,
        @Nullable Instant mayGoUntil) {
    /** From an order to step aside until it moves. */
    private static final Duration UNTIL_MOVING = Duration.ofMillis(1_500);
    /** From an order to stand until it shows. */
    private static final Duration UNTIL_SEEN = Duration.ofSeconds(3);

    static Yielding began(GiveWay give, Instant busyUntil, Command.@Nullable GoTo aside) {
        return new Yielding(give, give.since(), busyUntil, false, aside, null, null);
    }

    /** As it was before a restart: told, and long since standing. */
    public static Yielding restored(GiveWay give) {
        return new Yielding(give, give.since(), give.since(), true, null, null, null);
    }

    /** It had to wait for nobody, and is let go. */
    static Yielding toNobody(TrackedDrone drone, Instant now) {
        GiveWay give = new GiveWay(drone.id(), drone.name(), GiveWay.Manner.WAIT, now, true, null);
        return new Yielding(give, now, now, false, null, now, null);
    }

    DroneId to() {
        return give.to();
    }

    /** It had to wait, and longer than that. */
    boolean hasWaited(DroneId self, Duration longest, Instant now) {
        return !to().equals(self) && lasting(now).compareTo(longest) > 0;
    }

    boolean isBusy(Instant now) {
        return now.isBefore(busyUntil);
    }

    /** Told in flight: it is not under way to where its operation had it go. */
    boolean isOrdered() {
        return give.manner() != GiveWay.Manner.WAIT;
    }

    /** It is on the ground, and let go. */
    boolean mayRise() {
        return !isOrdered() && give.clear();
    }

    Yielding mayGoOn(Instant now) {
        Instant free = clearSince == null ? now : clearSince;
        return new Yielding(give.withClear(true), since, busyUntil, stood, aside, free, null);
    }

    Yielding mayNotGoOn() {
        return new Yielding(give.withClear(false), since, busyUntil, stood, aside, null, mayGoUntil);
    }

    /** It may go on, and does so in the next moments: others count with it. */
    boolean isSettingOff(Instant now) {
        return wasLetGoWithin(UNTIL_SEEN, now);
    }

    boolean wasLetGoWithin(Duration lately, Instant now) {
        return clearSince != null && Duration.between(clearSince, now).compareTo(lately) <= 0;
    }

    Yielding seenStanding() {
        return stood ? this : new Yielding(give, since, busyUntil, true, aside, clearSince, mayGoUntil);
    }

    /** It gives way to another one, or in another way, from now on. */
    Yielding again(GiveWay next, Instant until, Command.@Nullable GoTo there) {
        Instant told = next.since();
        Instant goesBy = isSettingOff(told) ? told.plus(UNTIL_MOVING) : mayGoUntil;
        return new Yielding(next, since, until, stood && next.manner() != GiveWay.Manner.WAIT, there, null, goesBy);
    }

    /** The order did not show in time: it was lost, or somebody has it go on. */
    boolean isUnheeded(Instant now) {
        return !stood && Duration.between(give.since(), now).compareTo(UNTIL_SEEN) > 0;
    }

    /** It may have been sent on by its operation in the moment in which it was told otherwise. */
    boolean mayGo(Instant now) {
        return mayGoUntil != null && now.isBefore(mayGoUntil);
    }

    /** It was told to step aside so long ago that it moves by now. */
    boolean shouldMove(Instant now) {
        return Duration.between(give.since(), now).compareTo(UNTIL_MOVING) > 0;
    }

    Duration lasting(Instant now) {
        return Duration.between(since, now);
    }
}
