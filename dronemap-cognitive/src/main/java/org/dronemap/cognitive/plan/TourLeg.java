package org.dronemap.cognitive.plan;

import java.util.List;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.stored.Stored;

/**
 * A leg of a planned tour from one stop to the next: straight from fix to fix, with a short stand at each. Between two
 * fixes a drone may be at any height between theirs.
 *
 * @param fixes the first when it sets off, the last when it arrives
 * @param joules drawn on it
 */
@Stored(names = "fixes joules")
public record TourLeg(List<TimedPlace> fixes, double joules) {
    public TourLeg {
        fixes = List.copyOf(fixes);
        if (fixes.size() < 2) {
            throw new IllegalArgumentException("a way has at least 2 fixes, not " + fixes.size());
        }
    }

    public double departsSeconds() {
        return fixes.get(0).seconds();
    }

    public double arrivesSeconds() {
        return fixes.get(fixes.size() - 1).seconds();
    }

    public Place from() {
        return fixes.get(0).place();
    }

    public Place to() {
        return fixes.get(fixes.size() - 1).place();
    }

    /** What lies between: the top of a take-off, turns round barriers, the top of a landing. */
    public List<Place> via() {
        return fixes.subList(1, fixes.size() - 1).stream()
                .map(TimedPlace::place)
                .toList();
    }
}
