package org.dronemap.cognitive.allocate;

import java.util.SplittableRandom;

/**
 * A 2-opt move of the search: turns a stretch of one tour round, or exchanges the ends of two tours (2-opt*). Strings
 * are too short to bring long tours into another shape; this is not. Tours in which drones wait for windows are left
 * alone.
 */
final class TwoOptMove {
    private static final int BREADTH = 8;

    private final TourLists tours;
    private final SearchCost worth;
    private final LegCosts costs;
    private final NeighbourLists near;
    private final SplittableRandom random;
    private final int breadth;

    TwoOptMove(TourLists tours, SearchCost worth, LegCosts costs, NeighbourLists near, SplittableRandom random) {
        this.tours = tours;
        this.worth = worth;
        this.costs = costs;
        this.near = near;
        this.random = random;
        breadth = costs.timed() ? 0 : Math.min(BREADTH, near.length());
    }

    /** The worth after one try; {@code current} when it would not be below the limit, and nothing was changed. */
    double tryOne(double current, double limit) {
        if (breadth == 0) {
            return current;
        }
        int one = random.nextInt(tours.waypoints);
        int other = near.get(one, random.nextInt(breadth));
        int r = tours.drone(one);
        int s = tours.drone(other);
        if (r == TourLists.NONE || s == TourLists.NONE) {
            return current;
        }
        return r == s ? turn(one, other, current, limit) : exchange(one, tours.prev(other), current, limit);
    }

    /** One is followed by the other, and what followed the one by what followed the other. */
    private double turn(int one, int other, double current, double limit) {
        int r = tours.drone(one);
        int afterOne = tours.next(one);
        int afterOther = tours.next(other);
        if (afterOne == other || afterOther == one) {
            return current;
        }
        double more = costs.seconds(r, one, other)
                + costs.seconds(r, afterOne, afterOther)
                - tours.out(one)
                - tours.out(other);
        double moreSum = costs.sumsSeconds()
                ? more
                : sum(r, one, other) + sum(r, afterOne, afterOther) - sum(r, one, afterOne) - sum(r, other, afterOther);
        if (current + worth.insertion(r, more, moreSum, Double.POSITIVE_INFINITY) >= limit) {
            return current;
        }
        boolean forward = tours.isBefore(one, other);
        int from = forward ? afterOne : afterOther;
        int to = forward ? other : one;
        tours.turn(from, to);
        double now = worth.current();
        if (now < limit && isFeasible(r)) {
            return now;
        }
        tours.turn(to, from);
        worth.current();
        return current;
    }

    /** Each goes on as the other did. */
    private double exchange(int one, int other, double current, double limit) {
        int r = tours.drone(one);
        int s = tours.drone(other);
        int afterOne = tours.next(one);
        int afterOther = tours.next(other);
        double moreSum = sum(r, one, isEnd(afterOther) ? tours.end(r) : afterOther)
                + sum(s, other, isEnd(afterOne) ? tours.end(s) : afterOne)
                - sum(r, one, afterOne)
                - sum(s, other, afterOther);
        if (current + worth.ofSum(moreSum) >= limit) {
            return current;
        }
        tours.exchangeTails(one, other);
        double now = worth.current();
        if (now < limit && isFeasible(r) && isFeasible(s)) {
            return now;
        }
        tours.exchangeTails(one, other);
        worth.current();
        return current;
    }

    private boolean isEnd(int place) {
        return !tours.isWaypoint(place);
    }

    private double sum(int r, int from, int to) {
        return costs.sumOf(r, from, to, costs.seconds(r, from, to));
    }

    /** Skills and charge; ways that lead nowhere cost too much as it is. */
    private boolean isFeasible(int r) {
        return (costs.unrestricted() || tours.isAllowed(r))
                && (!costs.limited() || InsertionFeasibility.withinRange(costs, r, tours.joules(r)));
    }
}
