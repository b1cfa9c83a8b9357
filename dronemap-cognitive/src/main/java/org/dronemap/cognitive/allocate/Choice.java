package org.dronemap.cognitive.allocate;

/** The best place so far for one waypoint, among those that were looked at. */
final class Choice {
    private final Tours tours;
    private final Worth worth;
    private final Costs costs;
    private final Room room;
    private double change;
    private int after;

    Choice(Tours tours, Worth worth, Costs costs) {
        this.tours = tours;
        this.worth = worth;
        this.costs = costs;
        room = new Room(tours, costs);
        clear();
    }

    final void clear() {
        change = Double.POSITIVE_INFINITY;
        after = Tours.NONE;
    }

    /** By how much the worth would change about. */
    double change() {
        return change;
    }

    /** The place that the waypoint is to follow, or {@link Tours#NONE}. */
    int after() {
        return after;
    }

    /** Looks at one place, {@code moreSeconds} being what the way gets longer by. */
    void judge(int waypoint, int r, int place, double moreSeconds) {
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
        Flight flight = room.flown(r, place, waypoint);
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
