package org.dronemap.cognitive.cost;

import java.util.List;
import org.dronemap.cognitive.problem.Barrier;

/** A circular barrier on the planner's plane, with scales of its own since the plane's are true elsewhere. */
final class CircleBarrier extends ChartBarrier {
    private static final int TURNS = Barrier.CIRCLE_TURNS;

    private final double x;
    private final double y;
    private final double scaleX;
    private final double scaleY;
    private final double radius;
    private final double doubt;

    /**
     * Centre, scales and radius of a disc on the chart.
     *
     * @param scaleX the chart's x times this is metres there
     * @param doubt by how many metres a circle on the globe and one on a plane differ at that size
     */
    record Disc(double x, double y, double scaleX, double scaleY, double radius, double doubt) {}

    CircleBarrier(Disc place, double low, double high, boolean keepIn) {
        super(low, high, keepIn);
        this.x = place.x();
        this.y = place.y();
        this.scaleX = place.scaleX();
        this.scaleY = place.scaleY();
        this.radius = place.radius();
        this.doubt = place.doubt();
    }

    @Override
    boolean isFree(double x1, double y1, double x2, double y2, double room) {
        double fromX = (x1 - x) * scaleX;
        double fromY = (y1 - y) * scaleY;
        double toX = (x2 - x) * scaleX;
        double toY = (y2 - y) * scaleY;
        if (isKeepIn()) {
            double most = radius - room - doubt;
            return most > 0 && fromX * fromX + fromY * fromY < most * most && toX * toX + toY * toY < most * most;
        }
        double least = radius + room + doubt;
        return SegmentDistances.squaredToOrigin(fromX, fromY, toX, toY) > least * least;
    }

    /** A disc to stay in is convex: nothing turns at its rim. */
    @Override
    void turns(double room, FreeSpace free, List<double[]> turns) {
        if (isKeepIn()) {
            return;
        }
        double rim = (radius + room + doubt) / Math.cos(Math.PI / TURNS);
        for (int i = 0; i < TURNS; i++) {
            double angle = 2 * Math.PI * i / TURNS;
            turns.add(new double[] {x + rim * Math.cos(angle) / scaleX, y + rim * Math.sin(angle) / scaleY});
        }
    }
}
