package org.dronemap.cognitive.operation;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.separation.GiveWay;

/** The longest time that a drone which somebody waits for stays on the ground for another one in its way up. */
public final class TakeOffPatience {
    private static final Duration LONGEST = Duration.ofMinutes(2);

    private TakeOffPatience() {}

    /** {@code since}: when it began to start. */
    public static boolean isOver(Instant since, Instant now) {
        return Duration.between(since, now).compareTo(LONGEST) >= 0;
    }

    /** Why it is given up. */
    public static String words(String name, GiveWay give) {
        return name + " cannot take off: " + give.toName() + " has not left its way up for " + LONGEST.toMinutes()
                + " min.";
    }
}
