package org.dronemap.core.conduct;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;

/** Highest speed that was kept up over several looks, in m/s: single ones are gusts and errors. One thread. */
final class LastingSpeed {
    private static final int LOOKS = 4;

    private final Deque<Double> last = new ArrayDeque<>();
    private double highest;

    void observe(double speed) {
        last.addLast(speed);
        if (last.size() > LOOKS) {
            last.removeFirst();
        }
        if (last.size() == LOOKS) {
            highest = Math.max(highest, Collections.min(last));
        }
    }

    /** What comes next is of another flight. */
    LastingSpeed interrupted() {
        last.clear();
        return this;
    }

    double highest() {
        return highest;
    }
}
