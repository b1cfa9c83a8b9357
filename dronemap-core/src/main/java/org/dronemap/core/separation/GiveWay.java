package org.dronemap.core.separation;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Notice to an operation that one of its drones gives way to another one: it stands until the operation has it go on.
 *
 * @param to the other one
 * @param toName as people call it
 * @param since when it was told this last
 * @param clear the other one has passed: it may go on
 * @param words what it was told beyond standing, such as: climbs 6 m; null: just to stand, or not to set off
 */
@Stored(names = "to toName manner since clear words")
public record GiveWay(
        DroneId to,
        String toName,
        Manner manner,
        Instant since,
        boolean clear,
        @Nullable String words) {
    /** So long after an operation has said that its drone means to set off, it is shown whether another one is in its way. */
    public static final Duration SHOWN_AFTER = Duration.ofSeconds(1);

    private static final String ANOTHER = "another drone";

    /** Manner of giving way. */
    @Stored(names = "WAIT STOP MOVE")
    public enum Manner {
        /** It does not set off. */
        WAIT,
        /** It was told to stand. */
        STOP,
        /** It was told to go a few metres aside. */
        MOVE
    }

    /** It was told to stand, or to step aside, and may not go on yet. */
    public boolean standsAside() {
        return manner != Manner.WAIT && !clear;
    }

    /** What that drone does for the other one, as a sentence. */
    public String sentence(String name) {
        if (words != null) {
            return name + " " + words + ", to make room for " + toName + ".";
        }
        String waits = manner == Manner.WAIT ? " waits on the ground until " : " waits until ";
        return name + waits + toName + " has passed.";
    }

    /** The same for people who may know nothing of the other drone. */
    public GiveWay withoutNaming(DroneId self) {
        return new GiveWay(self, ANOTHER, manner, since, clear, words);
    }

    /** After a restart: to whom is not known any more. */
    public static GiveWay toAnother(DroneId self, Instant now) {
        return new GiveWay(self, ANOTHER, Manner.STOP, now, false, null);
    }

    GiveWay withClear(boolean now) {
        return new GiveWay(to, toName, manner, since, now, words);
    }
}
