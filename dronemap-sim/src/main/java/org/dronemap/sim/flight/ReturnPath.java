package org.dronemap.sim.flight;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/**
 * The way that a simulated vehicle has come since it was armed, as corners: what lies in line is one leg, and a loop
 * is left out. Owned by its vehicle.
 */
public final class ReturnPath {
    /** The least way between two corners, and how far beside a leg a place may lie. */
    private static final double ACCURACY_METERS = 2;

    private static final double STRAIGHT_METERS = ACCURACY_METERS / 2;
    private static final int MOST_CORNERS = 300;

    /** The newest first. */
    private final Deque<NeuPosition> corners = new ArrayDeque<>();

    private boolean full;
    private boolean flownBack;

    /** Begins anew where that vehicle is; without a position no way is known. */
    public void begin(SimulatedCraft craft) {
        corners.clear();
        full = false;
        flownBack = false;
        if (craft.navigation().hasEstimate()) {
            corners.push(craft.body().position());
        }
    }

    /** Looks where it is; on its way back the path does not grow. */
    public void step(SimulatedCraft craft) {
        if (!flownBack && craft.armed() && craft.navigation().hasEstimate()) {
            add(craft.body().position());
        }
    }

    /** It is on its way back along it, or no longer. */
    public void setFlownBack(boolean on) {
        flownBack = on;
    }

    private void add(NeuPosition place) {
        NeuPosition newest = corners.peek();
        if (newest == null || newest.distanceTo(place) < ACCURACY_METERS) {
            return;
        }
        leaveOutLoop(place);
        if (isInLine(place)) {
            corners.pop();
        } else if (corners.size() == MOST_CORNERS) {
            full = true;
            return;
        }
        corners.push(place);
    }

    /** Back at a leg that was flown before: what came since does not count. */
    private void leaveOutLoop(NeuPosition place) {
        int newer = 0;
        int dropped = 0;
        NeuPosition end = null;
        for (NeuPosition begin : corners) {
            // The leg that it is on, and the one before, are no loop.
            if (end != null && newer > 2 && metersBeside(place, begin, end) < ACCURACY_METERS) {
                dropped = newer;
            }
            end = begin;
            newer++;
        }
        for (int corner = 0; corner < dropped; corner++) {
            corners.pop();
        }
    }

    private boolean isInLine(NeuPosition place) {
        Iterator<NeuPosition> newestFirst = corners.iterator();
        if (corners.size() < 2) {
            return false;
        }
        NeuPosition newest = newestFirst.next();
        return metersBeside(newest, newestFirst.next(), place) < STRAIGHT_METERS;
    }

    private static double metersBeside(NeuPosition place, NeuPosition begin, NeuPosition end) {
        double north = end.north() - begin.north();
        double east = end.east() - begin.east();
        double up = end.up() - begin.up();
        double length = north * north + east * east + up * up;
        double share = length == 0
                ? 0
                : ((place.north() - begin.north()) * north
                                + (place.east() - begin.east()) * east
                                + (place.up() - begin.up()) * up)
                        / length;
        double along = Math.max(0, Math.min(1, share));
        return place.distanceTo(
                new NeuPosition(begin.north() + along * north, begin.east() + along * east, begin.up() + along * up));
    }

    /** It knows the whole way back. */
    public boolean isKnown() {
        return !corners.isEmpty() && !full;
    }

    /** The newest corner, which it leaves out from now on; null when there is none. */
    public @Nullable NeuPosition next() {
        return corners.poll();
    }

    /** Takes a corner back that it has not come to. */
    public void putBack(NeuPosition corner) {
        corners.push(corner);
    }

    /** It has been farther away than where it began. */
    public boolean leadsAway() {
        return corners.size() > 1;
    }

    /** That was the last one. */
    public boolean isEmpty() {
        return corners.isEmpty();
    }
}
