package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.dronemap.cognitive.cost.AllocationDrone;
import org.dronemap.cognitive.cost.AllocationObjective.Measure;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.dronemap.cognitive.cost.AllocationWaypoint;
import org.dronemap.cognitive.cost.Legs;
import org.jspecify.annotations.Nullable;

/**
 * Time, energy and objective of each leg with the service at its end, as the search reads them. Small problems keep all
 * times in tables. Immutable, safe for several threads.
 */
final class LegCosts {
    /** Beyond this many entries a table misses the processor's cache more often than computing anew costs. */
    private static final long LARGEST_TABLE = 2_000_000;

    private final Legs legs;
    private final int places;
    private final Measure measure;
    private final int[] types;
    private final double[] ready;
    private final double[] range;
    private final boolean[] mustFly;
    private final boolean[] busy;
    private final double[] service;
    private final double[] watts;
    private final double[] opens;
    private final double[] closes;
    private final BitSet[] allowed;
    private final boolean timed;
    private final boolean limited;
    private final boolean alike;
    private final double @Nullable [][] tables;
    private final double @Nullable [] onlyTable;
    private final boolean unrestricted;

    LegCosts(AllocationProblem instance) {
        legs = instance.legs();
        places = legs.places();
        measure = instance.aim().measure();
        List<AllocationWaypoint> visits = instance.visits();
        List<AllocationDrone> carriers = instance.carriers();
        types = carriers.stream().mapToInt(AllocationDrone::type).toArray();
        ready = carriers.stream().mapToDouble(AllocationDrone::readySeconds).toArray();
        range = carriers.stream().mapToDouble(AllocationDrone::rangeJoules).toArray();
        mustFly = new boolean[carriers.size()];
        busy = new boolean[carriers.size()];
        for (int r = 0; r < mustFly.length; r++) {
            mustFly[r] = carriers.get(r).mustFly();
            busy[r] = carriers.get(r).busy();
        }
        allowed = visits.stream().map(AllocationWaypoint::drones).toArray(BitSet[]::new);
        service = new double[places];
        watts = new double[places];
        opens = new double[places];
        closes = new double[places];
        for (int place = 0; place < places; place++) {
            boolean visited = place < visits.size();
            service[place] = visited ? visits.get(place).serviceSeconds() : 0;
            watts[place] = visited ? visits.get(place).serviceWatts() : 0;
            opens[place] = visited ? visits.get(place).opensSeconds() : Double.NEGATIVE_INFINITY;
            closes[place] = visited ? visits.get(place).closesSeconds() : Double.POSITIVE_INFINITY;
        }
        timed = visits.stream().anyMatch(visit -> visit.opensSeconds() > 0 || Double.isFinite(visit.closesSeconds()));
        limited = carriers.stream().anyMatch(carrier -> Double.isFinite(carrier.rangeJoules()));
        alike = carriers.stream().map(AllocationDrone::type).distinct().count() <= 1;
        int kinds = carriers.stream().mapToInt(AllocationDrone::type).max().orElse(0) + 1;
        tables = (long) places * places * kinds <= LARGEST_TABLE ? tables(kinds) : null;
        onlyTable = tables != null && kinds == 1 ? tables[0] : null;
        unrestricted = Arrays.stream(allowed).allMatch(drones -> drones.cardinality() == carriers.size());
    }

    private double[][] tables(int kinds) {
        double[][] made = new double[kinds][places * places];
        for (int type = 0; type < kinds; type++) {
            for (int from = 0; from < places; from++) {
                for (int to = 0; to < places; to++) {
                    made[type][from * places + to] = legs.seconds(type, from, to) + service[to];
                }
            }
        }
        return made;
    }

    /** Flying there and serving it, as the drone does it. */
    double seconds(int drone, int from, int to) {
        double[] only = onlyTable;
        if (only != null) {
            return only[from * places + to];
        }
        double[][] all = tables;
        return all == null ? legs.seconds(types[drone], from, to) + service[to] : all[types[drone]][from * places + to];
    }

    /** Flying there and serving it. */
    double joules(int drone, int from, int to) {
        return legs.joules(types[drone], from, to) + service[to] * watts[to];
    }

    /** What a leg adds to the sum of the aim, waiting left out. */
    double sumOf(int drone, int from, int to, double seconds) {
        return switch (measure) {
            case SECONDS -> seconds;
            case METERS -> legs.meters(types[drone], from, to);
            case JOULES -> joules(drone, from, to);
        };
    }

    /** What calling at a waypoint on the way adds to the sum of the aim. */
    double moreSum(int drone, int after, int waypoint, int before, double moreSeconds) {
        return switch (measure) {
            case SECONDS -> moreSeconds;
            case METERS ->
                legs.meters(types[drone], after, waypoint)
                        + legs.meters(types[drone], waypoint, before)
                        - legs.meters(types[drone], after, before);
            case JOULES -> moreJoules(drone, after, waypoint, before);
        };
    }

    double moreJoules(int drone, int after, int waypoint, int before) {
        return joules(drone, after, waypoint) + joules(drone, waypoint, before) - joules(drone, after, before);
    }

    double readySeconds(int drone) {
        return ready[drone];
    }

    double rangeJoules(int drone) {
        return range[drone];
    }

    boolean mustFly(int drone) {
        return mustFly[drone];
    }

    /** Whether it visits something even with an empty tour. */
    boolean busy(int drone) {
        return busy[drone];
    }

    double serviceSeconds(int place) {
        return service[place];
    }

    double watts(int place) {
        return watts[place];
    }

    double opensSeconds(int place) {
        return opens[place];
    }

    double closesSeconds(int place) {
        return closes[place];
    }

    boolean allows(int waypoint, int drone) {
        return unrestricted || allowed[waypoint].get(drone);
    }

    /** Whether every drone may serve every waypoint. */
    boolean unrestricted() {
        return unrestricted;
    }

    /** Whether any waypoint has a window, so that drones may have to wait. */
    boolean timed() {
        return timed;
    }

    /** Whether any drone has a limit of energy. */
    boolean limited() {
        return limited;
    }

    boolean sumsSeconds() {
        return measure == Measure.SECONDS;
    }

    /** What flying there adds to the sum of the aim, service and waiting left out. */
    double travel(int drone, int from, int to) {
        return switch (measure) {
            case SECONDS -> legs.seconds(types[drone], from, to);
            case METERS -> legs.meters(types[drone], from, to);
            case JOULES -> legs.joules(types[drone], from, to);
        };
    }

    /** Whether all drones fly alike. */
    boolean alike() {
        return alike;
    }

    boolean sumsJoules() {
        return measure == Measure.JOULES;
    }
}
