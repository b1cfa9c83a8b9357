package org.dronemap.cognitive.allocate;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/** Tries every plan of a tiny problem, drone after drone, and leaves those that are no better already. */
final class ExactSearch {
    /** More ways to share out and to order than this are left to the annealed search. */
    private static final double MOST_PLANS = 300_000;

    private final TourLists tours;
    private final LegCosts costs;
    private final SearchCost worth;
    private final Deque<Integer>[] orders;
    private final boolean[] visited;
    private final int[][] best;
    private double bestExact;

    @SuppressWarnings({"unchecked", "rawtypes"})
    private ExactSearch(TourLists tours, LegCosts costs, SearchCost worth) {
        this.tours = tours;
        this.costs = costs;
        this.worth = worth;
        orders = new Deque[tours.drones];
        Arrays.setAll(orders, r -> new ArrayDeque<>());
        visited = new boolean[tours.waypoints];
        best = tours.orders();
        bestExact = worth.exact();
    }

    static boolean suits(TourLists tours) {
        double plans = 1;
        for (int waypoint = 0; waypoint < tours.waypoints && plans <= MOST_PLANS; waypoint++) {
            plans *= tours.drones + waypoint;
        }
        return plans <= MOST_PLANS;
    }

    /** The best plan of all; the tours at hand are what it has to be better than. */
    static int[][] best(TourLists tours, LegCosts costs, SearchCost worth) {
        ExactSearch search = new ExactSearch(tours, costs, worth);
        search.extend(0, new TourEvaluation(costs, 0), tours.start(0), new SearchCost.Totals(0, 0, 0));
        return search.best;
    }

    private void extend(int r, TourEvaluation flight, int at, SearchCost.Totals before) {
        close(r, flight, at, before);
        for (int waypoint = 0; waypoint < tours.waypoints; waypoint++) {
            if (visited[waypoint] || !costs.allows(waypoint, r)) {
                continue;
            }
            TourEvaluation further = flight.copy();
            further.fly(at, waypoint);
            if (further.late()
                    || !Double.isFinite(further.seconds())
                    || isDear(before.with(further.seconds(), further.sum()))) {
                continue;
            }
            visited[waypoint] = true;
            orders[r].addLast(waypoint);
            extend(r, further, waypoint, before);
            orders[r].removeLast();
            visited[waypoint] = false;
        }
    }

    /** Flies home, and goes on with the next drone. */
    private void close(int r, TourEvaluation flight, int at, SearchCost.Totals before) {
        boolean empty = orders[r].isEmpty();
        TourEvaluation home = flight.copy();
        home.fly(at, tours.end(r));
        if (!empty
                && (!Double.isFinite(home.seconds()) || !InsertionFeasibility.withinRange(costs, r, home.joules()))) {
            return;
        }
        SearchCost.Totals tally = empty ? without(r, home, before) : before.with(home.seconds(), home.sum());
        if (isDear(tally)) {
            return;
        }
        if (r + 1 < tours.drones) {
            extend(r + 1, new TourEvaluation(costs, r + 1), tours.start(r + 1), tally);
            return;
        }
        double exact = worth.exact(tally);
        for (int waypoint = 0; waypoint < visited.length; waypoint++) {
            exact += visited[waypoint] ? 0 : worth.leftOut(waypoint);
        }
        if (exact < bestExact) {
            bestExact = exact;
            Arrays.setAll(
                    best, i -> orders[i].stream().mapToInt(Integer::intValue).toArray());
        }
    }

    /** A drone that is given nothing may have to fly all the same. */
    private SearchCost.Totals without(int r, TourEvaluation home, SearchCost.Totals before) {
        SearchCost.Totals flown = costs.mustFly(r) ? before.with(home.seconds(), home.sum()) : before;
        return costs.busy(r) ? flown : flown.withIdle();
    }

    private boolean isDear(SearchCost.Totals tally) {
        return worth.exact(tally) >= bestExact;
    }
}
