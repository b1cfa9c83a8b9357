package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import org.dronemap.cognitive.cost.AllocationProblem;

/**
 * The tours of all drones as the search changes them: linked lists of places, with what each tour takes. What was
 * changed since the last {@link #commit()} can be taken back.
 */
final class TourLists {
    static final int NONE = -1;

    private static final int NEXT = 0;
    private static final int PREV = 1;
    private static final int DRONE = 2;
    private static final int FIELDS = 3;

    final int waypoints;
    final int drones;
    private final AllocationProblem instance;
    private final LegCosts costs;
    private final int[] next;
    private final int[] prev;
    private final int[] drone;
    private final double[] out;
    private final IndexSet absent;
    private final UndoLog journal = new UndoLog();

    private final int[] size;
    private final double[] seconds;
    private final double[] sums;
    private final double[] joules;
    private final IndexSet touched;
    private final int[] oldSize;
    private final double[] oldSeconds;
    private final double[] oldSums;
    private final double[] oldJoules;

    TourLists(AllocationProblem instance, LegCosts costs) {
        this.instance = instance;
        this.costs = costs;
        waypoints = instance.visits().size();
        drones = instance.carriers().size();
        int places = waypoints + 2 * drones;
        next = new int[places];
        prev = new int[places];
        drone = new int[places];
        out = new double[places];
        absent = new IndexSet(waypoints);
        size = new int[drones];
        seconds = new double[drones];
        sums = new double[drones];
        joules = new double[drones];
        touched = new IndexSet(drones);
        oldSize = new int[drones];
        oldSeconds = new double[drones];
        oldSums = new double[drones];
        oldJoules = new double[drones];
        set(new int[drones][0]);
    }

    /** Takes over an order of waypoints for each drone; what is in none is absent. This cannot be taken back. */
    final void set(int[][] orders) {
        Arrays.fill(drone, NONE);
        absent.fill();
        for (int r = 0; r < drones; r++) {
            int last = start(r);
            drone[last] = r;
            for (int waypoint : orders[r]) {
                join(last, waypoint);
                put(waypoint, r);
                last = waypoint;
            }
            join(last, end(r));
            drone[end(r)] = r;
            size[r] = orders[r].length;
        }
        surveyAll();
        commit();
    }

    int[][] orders() {
        int[][] orders = new int[drones][];
        for (int r = 0; r < drones; r++) {
            orders[r] = order(r);
        }
        return orders;
    }

    int[] order(int r) {
        int[] order = new int[size[r]];
        int place = next[start(r)];
        for (int i = 0; i < order.length; i++) {
            order[i] = place;
            place = next[place];
        }
        return order;
    }

    /** Sums all up anew, so that rounding does not add up over millions of moves. */
    void surveyAll() {
        for (int r = 0; r < drones; r++) {
            survey(r);
        }
    }

    private void survey(int r) {
        TourEvaluation flight = new TourEvaluation(costs, r);
        int end = end(r);
        for (int place = start(r); place != end; place = next[place]) {
            out[place] = costs.seconds(r, place, next[place]);
            flight.fly(place, next[place]);
        }
        seconds[r] = flight.seconds();
        sums[r] = flight.sum();
        joules[r] = flight.joules();
    }

    int start(int r) {
        return instance.start(r);
    }

    int end(int r) {
        return instance.end(r);
    }

    int next(int place) {
        return next[place];
    }

    int prev(int place) {
        return prev[place];
    }

    /** From this place to the next of its tour in seconds, the service there included. */
    double out(int place) {
        return out[place];
    }

    /** The drone that a place belongs to, or {@link #NONE} for an absent waypoint. */
    int drone(int place) {
        return drone[place];
    }

    boolean isWaypoint(int place) {
        return place < waypoints;
    }

    IndexSet absent() {
        return absent;
    }

    int size(int r) {
        return size[r];
    }

    /** When the tour ends, on the plan's clock. */
    double seconds(int r) {
        return seconds[r];
    }

    /** What the aim sums. */
    double sum(int r) {
        return sums[r];
    }

    double joules(int r) {
        return joules[r];
    }

    /** A drone in the air comes down somewhere, waypoints or not; one on the ground stays there. */
    boolean flies(int r) {
        return size[r] > 0 || costs.mustFly(r);
    }

    /** What the aim sums of what is really flown. */
    double flown(int r) {
        return flies(r) ? sums[r] : 0;
    }

    /** When the last tour ends, in seconds on the plan's clock; drones that stay on the ground end none. */
    double longest() {
        double longest = 0;
        for (int r = 0; r < drones; r++) {
            longest = flies(r) ? Math.max(longest, seconds[r]) : longest;
        }
        return longest;
    }

    /** What the aim sums over all tours. */
    double total() {
        double total = 0;
        for (int r = 0; r < drones; r++) {
            total += flown(r);
        }
        return total;
    }

    void insert(int waypoint, int after) {
        int r = drone[after];
        int before = next[after];
        touch(r);
        change(r, after, waypoint, before, 1);
        link(after, waypoint, costs.seconds(r, after, waypoint));
        link(waypoint, before, costs.seconds(r, waypoint, before));
        assign(waypoint, r);
        size[r]++;
        surveyIfTimed(r);
    }

    void remove(int waypoint) {
        int r = drone[waypoint];
        int after = prev[waypoint];
        int before = next[waypoint];
        touch(r);
        change(r, after, waypoint, before, -1);
        link(after, before, costs.seconds(r, after, before));
        assign(waypoint, NONE);
        size[r]--;
        surveyIfTimed(r);
    }

    /** Whether a waypoint comes before another one of the same tour: looks both ways at once. */
    boolean isBefore(int one, int other) {
        int ahead = one;
        int back = one;
        while (true) {
            ahead = next[ahead];
            back = prev[back];
            if (ahead == other || !isWaypoint(back)) {
                return true;
            }
            if (back == other || !isWaypoint(ahead)) {
                return false;
            }
        }
    }

    /** Turns a stretch of one tour round; not to be mixed with changes that are to be taken back. */
    void turn(int from, int to) {
        int r = drone[from];
        int before = prev[from];
        int after = next[to];
        int place = from;
        while (place != after) {
            int following = next[place];
            next[place] = prev[place];
            prev[place] = following;
            place = following;
        }
        join(before, to);
        join(from, after);
        survey(r);
    }

    /** What comes after two places of different tours is exchanged; not to be mixed with changes that are to be taken back. */
    void exchangeTails(int one, int other) {
        int r = drone[one];
        int s = drone[other];
        int mine = next[one];
        int lastMine = prev[end(r)];
        int yours = next[other];
        int lastYours = prev[end(s)];
        boolean mineIsEmpty = lastMine == one;
        boolean yoursIsEmpty = lastYours == other;
        join(one, yoursIsEmpty ? end(r) : yours);
        join(yoursIsEmpty ? one : lastYours, end(r));
        join(other, mineIsEmpty ? end(s) : mine);
        join(mineIsEmpty ? other : lastMine, end(s));
        assignChain(r);
        assignChain(s);
    }

    /** All that is linked up between a drone's start and its end is its own. */
    private void assignChain(int r) {
        int count = 0;
        for (int place = next[start(r)]; place != end(r); place = next[place]) {
            drone[place] = r;
            count++;
        }
        size[r] = count;
        survey(r);
    }

    /** Whether the drone may serve all that is in its tour. */
    boolean isAllowed(int r) {
        for (int place = next[start(r)]; place != end(r); place = next[place]) {
            if (!costs.allows(place, r)) {
                return false;
            }
        }
        return true;
    }

    /** Where drones wait for windows to open, no tour is the sum of its legs. */
    private void surveyIfTimed(int r) {
        if (costs.timed()) {
            survey(r);
        }
    }

    private void change(int r, int after, int waypoint, int before, int sign) {
        double more = costs.seconds(r, after, waypoint)
                + costs.seconds(r, waypoint, before)
                - costs.seconds(r, after, before);
        seconds[r] += sign * more;
        sums[r] += sign * costs.moreSum(r, after, waypoint, before, more);
        if (costs.limited()) {
            joules[r] += sign * costs.moreJoules(r, after, waypoint, before);
        }
    }

    private void touch(int r) {
        if (!touched.has(r)) {
            touched.add(r);
            oldSize[r] = size[r];
            oldSeconds[r] = seconds[r];
            oldSums[r] = sums[r];
            oldJoules[r] = joules[r];
        }
    }

    private void link(int place, int after, double secondsBetween) {
        journal.record(FIELDS * place + NEXT, next[place], out[place]);
        journal.record(FIELDS * after + PREV, prev[after], 0);
        join(place, after);
        out[place] = secondsBetween;
    }

    private void join(int place, int after) {
        next[place] = after;
        prev[after] = place;
    }

    private void assign(int waypoint, int r) {
        journal.record(FIELDS * waypoint + DRONE, drone[waypoint], 0);
        put(waypoint, r);
    }

    private void put(int waypoint, int r) {
        drone[waypoint] = r;
        if (r == NONE) {
            absent.add(waypoint);
        } else {
            absent.remove(waypoint);
        }
    }

    /** What was changed stays so. */
    void commit() {
        journal.clear();
        touched.clear();
    }

    /** Everything is again as at the last {@link #commit()}. */
    void rollback() {
        for (int i = journal.count() - 1; i >= 0; i--) {
            int place = journal.slot(i) / FIELDS;
            int value = journal.value(i);
            switch (journal.slot(i) % FIELDS) {
                case NEXT -> {
                    next[place] = value;
                    out[place] = journal.seconds(i);
                }
                case PREV -> prev[place] = value;
                default -> put(place, value);
            }
        }
        for (int i = 0; i < touched.size(); i++) {
            int r = touched.get(i);
            size[r] = oldSize[r];
            seconds[r] = oldSeconds[r];
            sums[r] = oldSums[r];
            joules[r] = oldJoules[r];
        }
        commit();
    }
}
