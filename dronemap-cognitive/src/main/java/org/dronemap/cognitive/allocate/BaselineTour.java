package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.jspecify.annotations.Nullable;

/** One drone's tour while a baseline method builds it, and what one waypoint more would cost. */
final class BaselineTour {
    private final AllocationProblem instance;
    private final LegCosts costs;
    private final int drone;
    private final List<Integer> order = new ArrayList<>();
    private double seconds;
    private int flown;

    BaselineTour(AllocationProblem instance, LegCosts costs, int drone) {
        this.instance = instance;
        this.costs = costs;
        this.drone = drone;
        survey();
    }

    static List<BaselineTour> all(AllocationProblem instance, LegCosts costs) {
        List<BaselineTour> rounds = new ArrayList<>();
        for (int r = 0; r < instance.carriers().size(); r++) {
            rounds.add(new BaselineTour(instance, costs, r));
        }
        return rounds;
    }

    /**
     * A place in the tour.
     *
     * @param position how many waypoints come before
     * @param seconds what the whole tour takes then
     */
    record InsertionPosition(int position, double seconds) {}

    /** Where the waypoint costs least among what is still to be flown, or null where the drone cannot call at it. */
    @Nullable
    InsertionPosition cheapest(int waypoint) {
        if (!costs.allows(waypoint, drone)) {
            return null;
        }
        int best = flown;
        double least = Double.POSITIVE_INFINITY;
        for (int position = flown; position <= order.size(); position++) {
            double more = more(waypoint, position);
            if (more < least) {
                least = more;
                best = position;
            }
        }
        return Double.isFinite(least) && fits(waypoint, best) ? new InsertionPosition(best, seconds + least) : null;
    }

    private double more(int waypoint, int position) {
        int before = place(position - 1);
        int after = place(position);
        double there = costs.seconds(drone, before, waypoint) + costs.seconds(drone, waypoint, after);
        return order.isEmpty() && !costs.mustFly(drone) ? there : there - costs.seconds(drone, before, after);
    }

    /** Whether the tour can be flown with the waypoint in it: windows are met, and the battery lasts. */
    private boolean fits(int waypoint, int position) {
        if (!costs.timed() && !costs.limited()) {
            return true;
        }
        order.add(position, waypoint);
        boolean can = canFly();
        order.remove(position);
        return can;
    }

    private boolean canFly() {
        TourEvaluation flight = flight();
        return !flight.late() && InsertionFeasibility.withinRange(costs, drone, flight.joules());
    }

    /** Whether the tour can be flown without it: a drone that is early waits, and waiting may draw more than flying. */
    boolean spares(int position) {
        if (!costs.timed() || !costs.limited()) {
            return true;
        }
        int waypoint = order.remove(position);
        boolean can = order.isEmpty() || canFly();
        order.add(position, waypoint);
        return can;
    }

    /** Leaves out the last waypoints until the tour can be flown. */
    void shorten() {
        while (!order.isEmpty() && costs.timed() && !canFly()) {
            remove(order.size() - 1);
        }
    }

    private TourEvaluation flight() {
        TourEvaluation flight = new TourEvaluation(costs, drone);
        for (int position = 0; position <= order.size(); position++) {
            flight.fly(place(position - 1), place(position));
        }
        return flight;
    }

    private int place(int position) {
        if (position < 0) {
            return instance.start(drone);
        }
        return position < order.size() ? order.get(position) : instance.end(drone);
    }

    /** Puts it at the end, where that can be flown. */
    boolean append(int waypoint) {
        int last = order.size();
        boolean can = costs.allows(waypoint, drone) && Double.isFinite(more(waypoint, last)) && fits(waypoint, last);
        if (can) {
            insert(waypoint, last);
        }
        return can;
    }

    void insert(int waypoint, int position) {
        seconds += more(waypoint, position);
        order.add(position, waypoint);
    }

    void remove(int position) {
        int waypoint = order.remove(position);
        seconds -= more(waypoint, position);
    }

    /** What leaving it out would save. */
    double saving(int position) {
        int before = place(position - 1);
        int waypoint = place(position);
        int after = place(position + 1);
        double direct = order.size() == 1 && !costs.mustFly(drone) ? 0 : costs.seconds(drone, before, after);
        return costs.seconds(drone, before, waypoint) + costs.seconds(drone, waypoint, after) - direct;
    }

    private void survey() {
        boolean flies = !order.isEmpty() || costs.mustFly(drone);
        seconds = flies ? flight().seconds() : costs.readySeconds(drone);
    }

    /** Its next waypoint is flown to: what comes before it in the tour stays as it is. */
    void move() {
        flown++;
    }

    boolean hasFlownAll() {
        return flown >= order.size();
    }

    int flown() {
        return flown;
    }

    int size() {
        return order.size();
    }

    int waypoint(int position) {
        return order.get(position);
    }

    int position(int waypoint) {
        return order.indexOf(waypoint);
    }

    /** When it ends, on the plan's clock, waiting for windows left out. */
    double seconds() {
        return seconds;
    }

    /** From the last waypoint, or the start. */
    double secondsOnTo(int waypoint) {
        return costs.seconds(drone, place(order.size() - 1), waypoint);
    }

    int[] order() {
        return order.stream().mapToInt(Integer::intValue).toArray();
    }
}
