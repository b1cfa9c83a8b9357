package org.dronemap.core.zone;

import java.util.List;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.FenceArea;

/** Checks whether a drone breaches a zone at its present position, without any margin. */
final class BreachCheck {
    private BreachCheck() {}

    /**
     * A height that is not known is taken for a forbidden one over a keep-out, and for an allowed one within an area to
     * stay in. The floor of such an area is not looked at: whoever takes off or lands is below it.
     */
    static boolean breaches(Zone zone, Geodetic point, Position position, HeightReferences levels) {
        boolean inside = isInside(zone.shape(), point);
        Double height = levels.bounded(position, zone.band().reference());
        if (zone.shape().inside()) {
            return !inside || (height != null && height > zone.band().highMeters());
        }
        return inside
                && (height == null
                        || (height >= zone.band().lowMeters()
                                && height <= zone.band().highMeters()));
    }

    private static boolean isInside(FenceArea shape, Geodetic point) {
        if (shape instanceof FenceArea.Circle circle) {
            PlanePoint seen = LocalPlane.offset(circle.center(), point);
            return Math.hypot(seen.eastMeters(), seen.northMeters()) <= circle.radiusMeters();
        }
        List<Geodetic> corners = shape instanceof FenceArea.Polygon polygon ? polygon.corners() : List.of();
        if (AreaExtent.isBeside(corners, AreaExtent.Box.at(point))) {
            return false;
        }
        LocalPlane plane = new LocalPlane(point);
        return plane.outline(corners).contains(plane.spot(point));
    }
}
