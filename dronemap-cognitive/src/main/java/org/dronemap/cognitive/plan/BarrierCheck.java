package org.dronemap.cognitive.plan;

import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlanePolygon;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;

/** Checks whether straight pieces of a drone's path enter a forbidden area or leave a required one. */
public final class BarrierCheck {
    private static final PlanePoint CENTER = new PlanePoint(0, 0);

    private final List<Barrier> barriers;
    private final double homeAmslMeters;
    private final double room;

    public BarrierCheck(List<Barrier> barriers, Craft craft) {
        this(barriers, craft, 0);
    }

    /** {@code room}: metres that are to be left beside what must not be touched. */
    BarrierCheck(List<Barrier> barriers, Craft craft, double room) {
        this.room = room;
        this.barriers =
                barriers.stream().filter(barrier -> barrier.binds(craft.id())).toList();
        this.homeAmslMeters = craft.homeAmslMeters();
    }

    /**
     * What the piece breaks, as the end of a sentence.
     *
     * @param column it rises from the ground, or comes down to it
     */
    public Optional<String> fault(TimedPlace from, TimedPlace to, boolean column) {
        for (Barrier barrier : barriers) {
            Optional<String> fault = barrier.isKeepIn() ? leaves(barrier, from, to) : enters(barrier, from, to, column);
            if (fault.isPresent()) {
                return fault;
            }
        }
        return Optional.empty();
    }

    private Optional<String> enters(Barrier barrier, TimedPlace from, TimedPlace to, boolean column) {
        double low = column ? Double.NEGATIVE_INFINITY : Math.min(height(from, barrier), height(to, barrier));
        double high = Math.max(height(from, barrier), height(to, barrier));
        boolean passes =
                low > barrier.band().highMeters() || high < barrier.band().lowMeters();
        return !passes
                        && touches(
                                barrier.shape(),
                                from.place().point(),
                                to.place().point())
                ? Optional.of("leads through " + barrier.words())
                : Optional.empty();
    }

    private Optional<String> leaves(Barrier barrier, TimedPlace from, TimedPlace to) {
        double high = Math.max(height(from, barrier), height(to, barrier));
        if (high > barrier.band().highMeters()) {
            return Optional.of("leads over the ceiling of " + barrier.words());
        }
        return isWithin(barrier.shape(), from.place().point(), to.place().point())
                ? Optional.empty()
                : Optional.of("leaves " + barrier.words());
    }

    private double height(TimedPlace fix, Barrier barrier) {
        double amsl = fix.place().altitudeAmslMeters();
        return barrier.band().reference() == Altitude.Reference.HOME ? amsl - homeAmslMeters : amsl;
    }

    private boolean touches(FenceArea shape, Geodetic from, Geodetic to) {
        if (shape instanceof FenceArea.Circle circle) {
            return around(circle, from, to).distanceMeters(CENTER) <= circle.radiusMeters() + room;
        }
        LocalPlane plane = new LocalPlane(from);
        PlaneSegment way = new PlaneSegment(plane.spot(from), plane.spot(to));
        PlanePolygon outline = plane.outline(((FenceArea.Polygon) shape).corners());
        return outline.contains(way.from())
                || outline.contains(way.to())
                || outline.edges().stream().anyMatch(edge -> edge.distanceMeters(way) <= room);
    }

    private boolean isWithin(FenceArea shape, Geodetic from, Geodetic to) {
        if (shape instanceof FenceArea.Circle circle) {
            PlaneSegment way = around(circle, from, to);
            return Math.max(way.from().distanceMeters(CENTER), way.to().distanceMeters(CENTER))
                    <= circle.radiusMeters() - room;
        }
        LocalPlane plane = new LocalPlane(from);
        PlaneSegment way = new PlaneSegment(plane.spot(from), plane.spot(to));
        PlanePolygon outline = plane.outline(((FenceArea.Polygon) shape).corners());
        return outline.contains(way.from())
                && outline.contains(way.to())
                && outline.edges().stream().noneMatch(edge -> edge.distanceMeters(way) <= room);
    }

    private static PlaneSegment around(FenceArea.Circle circle, Geodetic from, Geodetic to) {
        return new PlaneSegment(LocalPlane.offset(circle.center(), from), LocalPlane.offset(circle.center(), to));
    }
}
