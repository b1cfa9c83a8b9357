package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/** A time window in which a task may begin, in seconds on the plan's clock; infinite where open. */
@Stored(names = "opensSeconds closesSeconds")
public record TimeWindow(double opensSeconds, double closesSeconds) {
    public static final TimeWindow ALWAYS = new TimeWindow(0, Double.POSITIVE_INFINITY);

    public TimeWindow {
        Require.notNegative("opensSeconds", opensSeconds);
        if (!(closesSeconds >= opensSeconds)) {
            throw new IllegalArgumentException(
                    "closesSeconds must be at least opensSeconds (" + opensSeconds + "): " + closesSeconds);
        }
    }
}
