package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.geo.LocalPlane;
import org.jspecify.annotations.Nullable;

/**
 * Fits one tour of a plan between tours that are settled, by delaying and raising its legs as little as possible. Used
 * once, by one thread.
 */
final class TourScheduler {
    private static final double STEP_SECONDS = 2;
    private static final int STEPS = 300;
    private static final int LAYERS = 3;
    private static final double LAYER_ROOM_METERS = 1;
    private static final int LEAST_TRIES = 20_000;

    private final Craft craft;
    private final Tour tour;
    private final LocalPlane plane;
    private final List<TourTrajectory> settled;
    private final SeparationCheck check;
    private final Map<String, Waypoint> waypoints;
    private final RaisedTourLegs layers;
    private final double layerMeters;
    private final List<Option> tries;
    private final SearchNode[] legs;
    private int left;

    /** So much later than at once, and so high above the plan. */
    private record Option(double delaySeconds, int layer) {}

    /** The state of the search at one leg of the tour. */
    private static final class SearchNode {
        double free;
        int next;
        /** Waiting longer than this it is in somebody's way. */
        double longestDelay;

        double begins;
        double leaves;
        final @Nullable TourLeg[] heights = new TourLeg[LAYERS];
        final boolean[] known = new boolean[LAYERS];

        @Nullable
        TourLeg way;

        void enter(double seconds) {
            free = seconds;
            next = 0;
            longestDelay = Double.POSITIVE_INFINITY;
        }
    }

    TourScheduler(PlanningProblem problem, Craft craft, Tour tour, LocalPlane plane, List<TourTrajectory> settled) {
        this.craft = craft;
        this.tour = tour;
        this.plane = plane;
        this.settled = settled;
        this.check = new SeparationCheck(problem.rules().separation());
        this.waypoints = problem.waypoints().stream().collect(Collectors.toMap(Waypoint::id, Function.identity()));
        this.layers = new RaisedTourLegs(problem, craft, tour);
        this.layerMeters = problem.rules().separation().verticalMeters() + LAYER_ROOM_METERS;
        this.tries = tries();
        this.legs = new SearchNode[tour.stops().size() + 1];
        this.left = LEAST_TRIES + 200 * legs.length;
        for (int i = 0; i < legs.length; i++) {
            legs[i] = new SearchNode();
        }
    }

    private List<Option> tries() {
        double layerSeconds = layerMeters / craft.performance().speeds().climb()
                + layerMeters / craft.performance().speeds().descent();
        List<Option> all = new ArrayList<>(STEPS * LAYERS);
        for (int layer = 0; layer < LAYERS; layer++) {
            for (int step = 0; step < STEPS; step++) {
                all.add(new Option(step * STEP_SECONDS, layer));
            }
        }
        all.sort(Comparator.comparingDouble((Option one) -> one.delaySeconds() + one.layer() * layerSeconds)
                .thenComparingInt(Option::layer));
        return all;
    }

    Optional<Tour> find() {
        int at = 0;
        legs[0].enter(craft.start().readySeconds());
        while (at >= 0 && left > 0) {
            if (!advance(at)) {
                at--;
            } else if (at + 1 < legs.length) {
                at++;
                legs[at].enter(legs[at - 1].leaves);
            } else {
                Tour found = write();
                if (found.usedJoules() <= craft.supply().rangeJoules()) {
                    return Optional.of(found);
                }
            }
        }
        return Optional.empty();
    }

    /** To the next try of that way that is free. */
    private boolean advance(int at) {
        SearchNode leg = legs[at];
        while (leg.next < tries.size() && left > 0) {
            Option one = tries.get(leg.next++);
            TourLeg flat = one.delaySeconds() > leg.longestDelay ? null : height(at, one.layer());
            if (flat != null) {
                left--;
                if (isFree(at, shifted(flat, leg.free + one.delaySeconds()))) {
                    return true;
                }
            }
        }
        return false;
    }

    private @Nullable TourLeg height(int at, int layer) {
        SearchNode leg = legs[at];
        if (!leg.known[layer]) {
            leg.heights[layer] = layers.raised(at, layer * layerMeters);
            leg.known[layer] = true;
        }
        return leg.heights[layer];
    }

    private static TourLeg shifted(TourLeg way, double departs) {
        double later = departs - way.departsSeconds();
        return later == 0
                ? way
                : new TourLeg(
                        way.fixes().stream()
                                .map(fix -> new TimedPlace(fix.place(), fix.seconds() + later))
                                .toList(),
                        way.joules());
    }

    private boolean isFree(int at, TourLeg way) {
        SearchNode leg = legs[at];
        leg.way = way;
        leg.begins = way.arrivesSeconds();
        leg.leaves = craft.lands() ? leg.begins : Double.POSITIVE_INFINITY;
        if (at < tour.stops().size() && !visit(leg, tour.stops().get(at))) {
            return false;
        }
        boolean onGround = at == 0 && !craft.start().airborne();
        double since = onGround ? way.departsSeconds() : at == 0 ? 0 : leg.free;
        TourTrajectory trace = TourTrajectory.of(craft, since, way, leg.leaves, plane);
        for (TourTrajectory other : settled) {
            Optional<SeparationConflict> conflict = check.first(trace, other);
            if (conflict.isPresent()) {
                if (conflict.get().seconds() < way.departsSeconds()) {
                    leg.longestDelay = conflict.get().seconds() - leg.free;
                }
                return false;
            }
        }
        return true;
    }

    /** Whether it is there in time. */
    private boolean visit(SearchNode leg, TourStop stop) {
        Waypoint waypoint = waypoints.get(stop.waypoint());
        if (waypoint == null) {
            throw new IllegalArgumentException("the waypoint " + stop.waypoint() + " is not part of the problem");
        }
        leg.begins = Math.max(leg.begins, waypoint.window().opensSeconds());
        leg.leaves = leg.begins + waypoint.task().serviceSeconds();
        return leg.begins <= waypoint.window().closesSeconds();
    }

    private Tour write() {
        double joules = craft.start().airborne() ? way(0).departsSeconds() * layers.hoverWatts() : 0;
        List<TourStop> stops = new ArrayList<>(tour.stops().size());
        for (int i = 0; i < tour.stops().size(); i++) {
            TourLeg way = way(i);
            double arrives = way.arrivesSeconds();
            joules += way.joules() + (legs[i].leaves - arrives) * layers.hoverWatts();
            stops.add(new TourStop(tour.stops().get(i).waypoint(), way, legs[i].begins, legs[i].leaves, joules));
            joules += (way(i + 1).departsSeconds() - legs[i].leaves) * layers.hoverWatts();
        }
        TourLeg last = way(legs.length - 1);
        return new Tour(tour.drone(), stops, last, joules + last.joules());
    }

    private TourLeg way(int at) {
        TourLeg way = legs[at].way;
        if (way == null) {
            throw new IllegalStateException("way " + at + " was not found yet");
        }
        return way;
    }
}
