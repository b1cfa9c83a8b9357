package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlanePolygon;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.mission.FenceArea;
import org.jspecify.annotations.Nullable;

/** Compares a place, and the straight way to it, with one area of a vehicle's own fence, for warnings: without margins. */
final class FenceAreaCheck {
    private static final String OUTSIDE = " lies outside of an area that its own fence keeps it in.";
    private static final String INSIDE = " lies inside an area that its own fence keeps it out of.";
    private static final String LEAVES = " is reached by a way that leaves an area that its own fence keeps it in.";
    private static final String ENTERS = " is reached by a way that enters an area that its own fence keeps it out of.";
    private static final PlanePoint CENTER = new PlanePoint(0, 0);

    private FenceAreaCheck() {}

    static boolean covers(FenceArea area, Geodetic point) {
        if (area instanceof FenceArea.Polygon polygon) {
            LocalPlane plane = new LocalPlane(polygon.corners().get(0));
            return plane.outline(polygon.corners()).contains(plane.spot(point));
        }
        FenceArea.Circle circle = (FenceArea.Circle) area;
        return LocalPlane.offset(circle.center(), point).distanceMeters(CENTER) <= circle.radiusMeters();
    }

    /** The end of a sentence that begins with the place; {@code from}: where the way begins, null when not known. */
    static Optional<String> against(FenceArea area, @Nullable Geodetic from, Geodetic to) {
        if (covers(area, to) != area.inside()) {
            return Optional.of(area.inside() ? OUTSIDE : INSIDE);
        }
        // Whoever is on the wrong side already cannot but come across.
        if (from == null || covers(area, from) != area.inside() || !meets(area, from, to)) {
            return Optional.empty();
        }
        return Optional.of(area.inside() ? LEAVES : ENTERS);
    }

    /** Whether the way between two places on one side of its edge crosses that. */
    private static boolean meets(FenceArea area, Geodetic from, Geodetic to) {
        if (area instanceof FenceArea.Polygon polygon) {
            LocalPlane plane = new LocalPlane(polygon.corners().get(0));
            PlanePolygon outline = plane.outline(polygon.corners());
            PlaneSegment way = new PlaneSegment(plane.spot(from), plane.spot(to));
            return outline.edges().stream().anyMatch(way::crosses);
        }
        FenceArea.Circle circle = (FenceArea.Circle) area;
        PlaneSegment way =
                new PlaneSegment(LocalPlane.offset(circle.center(), from), LocalPlane.offset(circle.center(), to));
        return !circle.inside() && way.distanceMeters(CENTER) <= circle.radiusMeters();
    }
}
