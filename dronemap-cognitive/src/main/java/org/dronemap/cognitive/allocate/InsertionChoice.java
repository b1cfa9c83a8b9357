package org.dronemap.cognitive.allocate;

/** The cheapest position found so far for inserting one waypoint into a tour. */
final class InsertionChoice {
    private final TourLists tours;
    private final SearchCost worth;
    private final LegCosts costs;
    private final InsertionFeasibility room;
    private double change;
    private int after;

    InsertionChoice(TourLists tours, SearchCost worth, LegCosts costs) {
        this.tours = tours;
        this.worth = worth;
        this.costs = costs;
        room = new InsertionFeasibility(tours, costs);
        clear();
    }

    final void clear() {
        change = Double.POSITIVE_INFINITY;
        after = TourLists.NONE;
    }

    /** By how much the worth would change about. */
    double change() {
        return change;
    }

    /** The place that the waypoint is to follow, or {@link TourLists#NONE}. */
    int after() {
        return after;
    }

    /** Looks before and after a waypoint of that tour. */
    void beside(int waypoint, int r, int other) {
        int before = tours.prev(other);
        int after = tours.next(other);
        double ahead = costs.seconds(r, before, waypoint) + costs.seconds(r, waypoint, other) - tours.out(before);
        double behind = costs.seconds(r, other, waypoint) + costs.seconds(r, waypoint, after) - tours.out(other);
        if (costs.timed()) {
            judge(waypoint, r, before, ahead);
            judge(waypoint, r, other, behind);
        } else if (ahead < behind) {
            judge(waypoint, r, before, ahead);
        } else {
            judge(waypoint, r, other, behind);
        }
    }

    /** Looks at the start and at the end of a tour. */
    void atAnEnd(int waypoint, int r) {
        int start = tours.start(r);
        int first = tours.next(start);
        judge(waypoint, r, start, more(waypoint, r, start, first));
        int last = tours.prev(tours.end(r));
        if (last != start) {
            judge(waypoint, r, last, more(waypoint, r, last, tours.end(r)));
        }
    }

    private double more(int waypoint, int r, int after, int before) {
        return costs.seconds(r, after, waypoint) + costs.seconds(r, waypoint, before) - tours.out(after);
    }

    /** Looks at all places of a tour. */
    void everywhere(int waypoint, int r) {
        int end = tours.end(r);
        for (int place = tours.start(r); place != end; place = tours.next(place)) {
            judge(waypoint, r, place, more(waypoint, r, place, tours.next(place)));
        }
    }

    /** Looks at one place, {@code moreSeconds} being what the way gets longer by. */
    private void judge(int waypoint, int r, int place, double moreSeconds) {
        if (!Double.isFinite(moreSeconds)) {
            return;
        }
        if (costs.timed()) {
            judgeFlown(waypoint, r, place);
            return;
        }
        double moreSum = costs.moreSum(r, place, waypoint, tours.next(place), moreSeconds);
        double its = worth.insertion(r, moreSeconds, moreSum, change);
        if (its < change && room.fits(r, place, waypoint)) {
            change = its;
            after = place;
        }
    }

    /** Waiting for windows counts as well. */
    private void judgeFlown(int waypoint, int r, int place) {
        TourEvaluation flight = room.flown(r, place, waypoint);
        if (flight == null) {
            return;
        }
        double moreSum = flight.sum() - tours.sum(r);
        double its = worth.insertion(r, flight.seconds() - tours.seconds(r), moreSum, change);
        if (its < change) {
            change = its;
            after = place;
        }
    }
}
