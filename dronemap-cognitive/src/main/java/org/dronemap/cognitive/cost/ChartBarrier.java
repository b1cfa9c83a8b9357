package org.dronemap.cognitive.cost;

import java.util.List;

/** A barrier projected onto the planner's plane, with the heights at which it stands. Never changes. */
abstract class ChartBarrier {
    /** Of the heights above the sea at which it stands, as wide as they may be meant. */
    private final double low;

    private final double high;
    private final boolean keepIn;

    ChartBarrier(double low, double high, boolean keepIn) {
        this.low = low;
        this.high = high;
        this.keepIn = keepIn;
    }

    final double low() {
        return low;
    }

    final double high() {
        return high;
    }

    final boolean isKeepIn() {
        return keepIn;
    }

    /** Whether a straight piece keeps that room to it: outside it, or inside when drones must stay in it. */
    abstract boolean isFree(double x1, double y1, double x2, double y2, double room);

    /** Where ways round it turn, with that room beside them; one spot a corner if a drone may be there. */
    abstract void turns(double room, FreeSpace free, List<double[]> turns);

    /** A test for points where drones may be. */
    interface FreeSpace {
        boolean contains(double x, double y);
    }
}
