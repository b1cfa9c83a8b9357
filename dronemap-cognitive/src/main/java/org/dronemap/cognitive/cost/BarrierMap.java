package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.PlanningRules;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.jspecify.annotations.Nullable;

/**
 * The barriers that bind one group of drones, with a visibility graph for each set that blocks a height. Which of it is
 * in the way depends on how high a leg leads: each such choice has a maze of its own. Safe for several threads.
 */
final class BarrierMap {
    /** How far heights above home and above the sea may be off each other for the command gate, and a little. */
    private static final double HEIGHT_DOUBT_METERS = 0.55;
    /** Barriers beyond so many with bounded heights are taken to stand at all heights. */
    private static final int MOST_CHOICES = 62;

    private record NamedBarrier(ChartBarrier block, String words) {}

    private final List<NamedBarrier> all = new ArrayList<>();
    private final List<ChartBarrier> everywhere = new ArrayList<>();
    private final List<ChartBarrier> layered = new ArrayList<>();
    private final List<ChartBarrier> stays = new ArrayList<>();
    private final List<ChartBarrier> outs = new ArrayList<>();
    private final Map<Long, VisibilityGraph> mazes = new ConcurrentHashMap<>();
    private final ProjectionError bend;
    private final double[] rooms;

    BarrierMap(DroneTypes.BarrierSet region, PlaceTable track, PlanningRules rules) {
        this.bend = ProjectionError.at(track.steepestDegrees());
        // short ways pass close by; long ones need more room than short ones have
        double far = 1.5 * bend.room(track.extentMeters()) + bend.meters(track.extentMeters());
        this.rooms = far > 2 * rules.roomMeters()
                ? new double[] {rules.roomMeters(), far}
                : new double[] {Math.max(rules.roomMeters(), far)};
        for (Barrier barrier : region.barriers()) {
            ChartBarrier block = block(barrier, region.homeAmslMeters(), track.chart);
            all.add(new NamedBarrier(block, barrier.words()));
            boolean choice = !block.isKeepIn()
                    && layered.size() < MOST_CHOICES
                    && (block.low() > Double.NEGATIVE_INFINITY || block.high() < Double.POSITIVE_INFINITY);
            (choice ? layered : everywhere).add(block);
            (block.isKeepIn() ? stays : outs).add(block);
        }
    }

    private ChartBarrier block(Barrier barrier, double homeAmslMeters, EquirectangularPlane chart) {
        double zero = barrier.band().reference() == Altitude.Reference.HOME ? homeAmslMeters : 0;
        double doubt = barrier.isKeepIn() ? -HEIGHT_DOUBT_METERS : HEIGHT_DOUBT_METERS;
        double low = zero + barrier.band().lowMeters() - doubt;
        double high = zero + barrier.band().highMeters() + doubt;
        if (barrier.shape() instanceof FenceArea.Circle circle) {
            return new CircleBarrier(place(circle, chart), low, high, barrier.isKeepIn());
        }
        List<Geodetic> corners = ((FenceArea.Polygon) barrier.shape()).corners();
        double[][] ring = new double[corners.size()][];
        double first = chart.x(corners.get(0));
        for (int i = 0; i < ring.length; i++) {
            double x = first + chart.x(LocalPlane.eastward(corners.get(0), corners.get(i)));
            ring[i] = new double[] {x, chart.y(corners.get(i))};
        }
        return new PolygonBarrier(ring, bend, low, high, barrier.isKeepIn());
    }

    private static CircleBarrier.Disc place(FenceArea.Circle circle, EquirectangularPlane chart) {
        double latitude = circle.center().latitudeDegrees();
        double doubt = 1e-5 * circle.radiusMeters()
                + circle.radiusMeters()
                        * circle.radiusMeters()
                        * ProjectionError.at(latitude).factor()
                        * 2;
        return new CircleBarrier.Disc(
                chart.x(circle.center()),
                chart.y(circle.center()),
                chart.stretch(latitude),
                chart.stretchNorth(latitude),
                circle.radiusMeters(),
                doubt);
    }

    /** The one for legs between two heights; to be asked for often. */
    VisibilityGraph at(double low, double high) {
        long choice = 0;
        for (int i = 0; i < layered.size(); i++) {
            ChartBarrier block = layered.get(i);
            if (block.low() <= high && block.high() >= low) {
                choice |= 1L << i;
            }
        }
        VisibilityGraph known = mazes.get(choice);
        return known == null ? mazes.computeIfAbsent(choice, this::maze) : known;
    }

    private VisibilityGraph maze(long choice) {
        List<ChartBarrier> blocks = new ArrayList<>(everywhere);
        for (int i = 0; i < layered.size(); i++) {
            if ((choice & 1L << i) != 0) {
                blocks.add(layered.get(i));
            }
        }
        return new VisibilityGraph(blocks, bend, rooms);
    }

    /** What keeps a drone from being there, at that height; null when nothing does. */
    @Nullable
    String obstacle(double x, double y, double altitude) {
        for (NamedBarrier one : all) {
            boolean within =
                    altitude >= one.block().low() && altitude <= one.block().high();
            boolean spot = one.block().isFree(x, y, x, y, bend.room(0));
            if (one.block().isKeepIn() ? !within || !spot : within && !spot) {
                return one.words();
            }
        }
        return null;
    }

    /** Whether all areas to stay in reach so high, and so low. */
    boolean allows(double low, double high) {
        for (ChartBarrier block : stays) {
            if (high > block.high() || low < block.low()) {
                return false;
            }
        }
        return true;
    }

    /** How high a drone may rise from the ground there, or come down from. */
    double columnTop(double x, double y) {
        double top = Double.POSITIVE_INFINITY;
        for (ChartBarrier block : outs) {
            if (!block.isFree(x, y, x, y, bend.room(0))) {
                top = Math.min(top, block.low());
            }
        }
        return top;
    }
}
