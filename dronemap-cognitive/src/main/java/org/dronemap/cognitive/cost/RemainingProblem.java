package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The allocation problem that is left when each drone has the firm beginning of its tour, numbered anew. Immutable. */
public final class RemainingProblem {
    private final AllocationProblem whole;
    private final AllocationProblem rest;
    private final int[][] begun;
    private final int[] open;
    private final int[] numbers;
    private final double sum;

    private RemainingProblem(AllocationProblem whole, AllocationProblem rest, int[][] begun, int[] open, double sum) {
        this.whole = whole;
        this.rest = rest;
        this.begun = begun;
        this.open = open;
        this.sum = sum;
        numbers = new int[whole.visits().size()];
        Arrays.fill(numbers, -1);
        for (int i = 0; i < open.length; i++) {
            numbers[open[i]] = i;
        }
    }

    /** With the waypoints that each drone visits first, as many of them as it still can. */
    public static RemainingProblem of(AllocationProblem whole, int[][] firm) {
        int waypoints = whole.visits().size();
        int drones = whole.carriers().size();
        int[][] begun = new int[drones][];
        List<AllocationDrone> carriers = new ArrayList<>(drones);
        boolean[] taken = new boolean[waypoints];
        double sum = 0;
        int[] ends = new int[2 * drones];
        for (int r = 0; r < drones; r++) {
            TourPrefix beginning = new TourPrefix(whole, r, firm[r]);
            begun[r] = beginning.order();
            for (int waypoint : begun[r]) {
                taken[waypoint] = true;
            }
            carriers.add(beginning.carrier());
            sum += beginning.sum();
            ends[2 * r] = beginning.place();
            ends[2 * r + 1] = whole.end(r);
        }
        int[] open = new int[waypoints];
        int count = 0;
        for (int waypoint = 0; waypoint < waypoints; waypoint++) {
            if (!taken[waypoint]) {
                open[count++] = waypoint;
            }
        }
        open = Arrays.copyOf(open, count);
        List<AllocationWaypoint> visits =
                Arrays.stream(open).mapToObj(whole.visits()::get).toList();
        int[] places = Arrays.copyOf(open, count + 2 * drones);
        System.arraycopy(ends, 0, places, count, ends.length);
        Legs legs = count == waypoints ? whole.legs() : new SomeLegs(whole.legs(), places);
        return new RemainingProblem(
                whole, new AllocationProblem(legs, visits, carriers, whole.aim()), begun, open, sum);
    }

    public AllocationProblem whole() {
        return whole;
    }

    /** What is left. */
    public AllocationProblem rest() {
        return rest;
    }

    /** What the beginnings add to what the aim sums. */
    public double sum() {
        return sum;
    }

    /** Tours of the whole problem without their beginnings, as tours of what is left. */
    public int[][] rest(int[][] orders) {
        return Arrays.stream(orders)
                .map(order -> Arrays.stream(order)
                        .map(waypoint -> numbers[waypoint])
                        .filter(number -> number >= 0)
                        .toArray())
                .toArray(int[][]::new);
    }

    /** Tours of what is left, with their beginnings, as tours of the whole problem. */
    public int[][] whole(int[][] orders) {
        int[][] all = new int[orders.length][];
        for (int r = 0; r < orders.length; r++) {
            int first = begun[r].length;
            all[r] = Arrays.copyOf(begun[r], first + orders[r].length);
            for (int i = 0; i < orders[r].length; i++) {
                all[r][first + i] = open[orders[r][i]];
            }
        }
        return all;
    }

    /** Some places of a problem, numbered anew. */
    private static final class SomeLegs implements Legs {
        private final Legs legs;
        private final int[] of;

        SomeLegs(Legs legs, int[] of) {
            this.legs = legs;
            this.of = of;
        }

        @Override
        public int places() {
            return of.length;
        }

        @Override
        public double eastMeters(int place) {
            return legs.eastMeters(of[place]);
        }

        @Override
        public double northMeters(int place) {
            return legs.northMeters(of[place]);
        }

        @Override
        public double seconds(int type, int from, int to) {
            return legs.seconds(type, of[from], of[to]);
        }

        @Override
        public double meters(int type, int from, int to) {
            return legs.meters(type, of[from], of[to]);
        }

        @Override
        public double joules(int type, int from, int to) {
            return legs.joules(type, of[from], of[to]);
        }
    }
}
