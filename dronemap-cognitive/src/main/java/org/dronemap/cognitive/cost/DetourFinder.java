package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Finds the shortest paths between places round the barriers that bind one group of drones. Safe for several threads.
 */
final class DetourFinder {
    /** Trees that are kept for the places that come next, by the size of them all. */
    private static final int KEPT_TURNS = 2_000_000;

    private final PlaceTable track;
    private final FlightModel[] paces;
    private final BarrierMap surroundings;
    private final double[] columnTops;
    private final Detour.CostsByType unreachable;
    private final Map<VisibilityGraph, VisibleTurns> seen = new ConcurrentHashMap<>();

    /** A cache of the turns visible from each place of a visibility graph, and of the shortest paths from there. */
    private static final class VisibleTurns {
        final AtomicReferenceArray<int[]> turns;
        final AtomicReferenceArray<SourceTree> trees;

        VisibleTurns(int places, int turns) {
            this.turns = new AtomicReferenceArray<>(places);
            this.trees = new AtomicReferenceArray<>(Math.max(1, Math.min(places, KEPT_TURNS / Math.max(1, turns))));
        }
    }

    private record SourceTree(int place, VisibilityGraph.ShortestPathTree tree) {}

    DetourFinder(PlaceTable track, FlightModel[] paces, BarrierMap surroundings) {
        this.track = track;
        this.paces = paces;
        this.surroundings = surroundings;
        this.unreachable = Detour.CostsByType.unreachable(paces.length);
        this.columnTops = new double[track.places];
        for (int place = track.waypoints; place < track.places; place++) {
            columnTops[place] = track.ground[place]
                    ? surroundings.columnTop(track.x[place], track.y[place])
                    : Double.POSITIVE_INFINITY;
        }
    }

    @Nullable
    String obstacle(int waypoint) {
        return surroundings.obstacle(track.x[waypoint], track.y[waypoint], track.altitude[waypoint]);
    }

    Detour find(int from, int to) {
        double leaves = track.leaves(from, to);
        double reaches = track.reaches(from, to);
        boolean rises = !track.ground[from] || leaves < columnTops[from];
        boolean lands = !track.ground[to] || reaches < columnTops[to];
        double low = Math.min(leaves, reaches);
        double high = Math.max(leaves, reaches);
        if (!rises || !lands || !surroundings.allows(low, high)) {
            return new Detour(from, to, List.of(), unreachable);
        }
        VisibilityGraph maze = surroundings.at(low, high);
        if (maze.isFree(track.x[from], track.y[from], track.x[to], track.y[to])) {
            return new Detour(from, to, List.of(), null);
        }
        int[] turns = around(maze, from, to);
        return turns == null
                ? new Detour(from, to, List.of(), unreachable)
                : detour(
                        from,
                        to,
                        Arrays.stream(turns)
                                .mapToObj(turn -> track.chart.point(maze.x(turn), maze.y(turn)))
                                .toList());
    }

    private int @Nullable [] around(VisibilityGraph maze, int from, int to) {
        VisibleTurns known = seen.computeIfAbsent(maze, some -> new VisibleTurns(track.places, some.turns()));
        int slot = from % known.trees.length();
        SourceTree rooted = known.trees.get(slot);
        if (rooted == null || rooted.place() != from) {
            rooted = new SourceTree(
                    from, maze.new ShortestPathTree(track.x[from], track.y[from], seenFrom(maze, known, from)));
            known.trees.set(slot, rooted);
        }
        return rooted.tree().to(track.x[to], track.y[to], seenFrom(maze, known, to));
    }

    private int[] seenFrom(VisibilityGraph maze, VisibleTurns known, int place) {
        int[] turns = known.turns.get(place);
        if (turns == null) {
            turns = maze.seenFrom(track.x[place], track.y[place]);
            known.turns.set(place, turns);
        }
        return turns;
    }

    private Detour detour(int from, int to, List<Geodetic> turns) {
        double leaves = track.leaves(from, to);
        double reaches = track.reaches(from, to);
        List<double[]> pieces = pieces(from, to, turns, leaves, reaches);
        double meters = leaves - track.altitude[from] + reaches - track.altitude[to];
        for (double[] piece : pieces) {
            meters += Math.sqrt(piece[0] * piece[0] + piece[1] * piece[1] + piece[2] * piece[2]);
        }
        double[] seconds = new double[paces.length];
        double[] joules = new double[paces.length];
        for (int type = 0; type < paces.length; type++) {
            FlightModel pace = paces[type];
            if (track.ground[from]) {
                seconds[type] += pace.riseSeconds(leaves - track.altitude[from]);
                joules[type] += pace.riseJoules(leaves - track.altitude[from]);
            }
            for (double[] piece : pieces) {
                seconds[type] += pace.seconds(piece[0], piece[1], piece[2]);
                joules[type] += pace.joules(piece[0], piece[1], piece[2]);
            }
            if (track.ground[to]) {
                seconds[type] += pace.landingSeconds(reaches - track.altitude[to]);
                joules[type] += pace.landingJoules(reaches - track.altitude[to]);
            }
        }
        return new Detour(from, to, turns, new Detour.CostsByType(meters, seconds, joules));
    }

    /** East, north and up; turns are flown at the greater of both heights. */
    private List<double[]> pieces(int from, int to, List<Geodetic> turns, double leaves, double reaches) {
        EquirectangularPlane chart = track.chart;
        double high = Math.max(leaves, reaches);
        double[] at = {track.x[from], track.stretch[from], track.north[from], leaves};
        List<double[]> pieces = new ArrayList<>(turns.size() + 1);
        for (Geodetic turn : turns) {
            double latitude = turn.latitudeDegrees();
            double[] next = {chart.x(turn), chart.stretch(latitude), chart.trueNorth(latitude), high};
            pieces.add(piece(at, next));
            at = next;
        }
        pieces.add(piece(at, new double[] {track.x[to], track.stretch[to], track.north[to], reaches}));
        return pieces;
    }

    private static double[] piece(double[] from, double[] to) {
        return new double[] {(to[0] - from[0]) * (from[1] + to[1]) / 2, to[2] - from[2], to[3] - from[3]};
    }
}
