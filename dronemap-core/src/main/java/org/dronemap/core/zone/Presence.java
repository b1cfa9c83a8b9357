package org.dronemap.core.zone;

import java.util.List;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceZone;
import org.jspecify.annotations.Nullable;

/** Whether a drone is where a zone does not want it, here and now, without any allowance. */
final class Presence {
    private Presence() {}

    /**
     * A height that is not known is taken for a forbidden one over a keep-out, and for an allowed one within an area to
     * stay in. The floor of such an area is not looked at: whoever takes off or lands is below it.
     */
    static boolean breaches(Zone zone, Geodetic point, Position position, @Nullable Double homeAmslMeters) {
        boolean inside = isInside(zone.shape(), point);
        Double height = height(position, zone.band().reference(), homeAmslMeters);
        if (zone.shape().inside()) {
            return !inside || (height != null && height > zone.band().highMeters());
        }
        return inside
                && (height == null
                        || (height >= zone.band().lowMeters()
                                && height <= zone.band().highMeters()));
    }

    private static boolean isInside(FenceZone shape, Geodetic point) {
        if (shape instanceof FenceZone.Circle circle) {
            Spot seen = LocalPlane.offset(circle.center(), point);
            return Math.hypot(seen.eastMeters(), seen.northMeters()) <= circle.radiusMeters();
        }
        List<Geodetic> corners = shape instanceof FenceZone.Polygon polygon ? polygon.corners() : List.of();
        LocalPlane plane = new LocalPlane(point);
        return plane.outline(corners).contains(plane.spot(point));
    }

    private static @Nullable Double height(
            Position position, Altitude.Reference reference, @Nullable Double homeAmslMeters) {
        Double above = position.altitudeAboveHomeMeters();
        Double amsl = position.altitudeAmslMeters();
        if (reference == Altitude.Reference.HOME) {
            return above != null || amsl == null || homeAmslMeters == null
                    ? above
                    : Double.valueOf(amsl - homeAmslMeters);
        }
        return amsl != null || above == null || homeAmslMeters == null ? amsl : Double.valueOf(above + homeAmslMeters);
    }
}
