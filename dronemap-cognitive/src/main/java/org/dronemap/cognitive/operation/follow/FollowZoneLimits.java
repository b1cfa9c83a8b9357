package org.dronemap.cognitive.operation.follow;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.follow.FlyableArea;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.Zone;

/** Computes from zones the flyable area and the ceiling for drones that follow a phone. */
final class FollowZoneLimits {
    private static final double MARGIN_METERS = 5;
    private static final double UNDER_METERS = 2;
    private static final int CORNERS = 36;

    private FollowZoneLimits() {}

    static FlyableArea room(Geodetic near, List<Zone> zones) {
        List<List<Geodetic>> stayIn = new ArrayList<>();
        List<List<Geodetic>> keepOut = new ArrayList<>();
        for (Zone zone : zones) {
            (zone.shape().inside() ? stayIn : keepOut).add(corners(zone.shape()));
        }
        return FlyableArea.of(near, stayIn, keepOut, MARGIN_METERS);
    }

    /** What drones are led no higher than by themselves: a little below the lowest ceiling of those that they stay in. */
    static double ceilingAmslMeters(List<Zone> zones, double homeAmslMeters) {
        return zones.stream()
                        .filter(zone -> zone.shape().inside())
                        .map(Zone::band)
                        .mapToDouble(band ->
                                band.highMeters() + (band.reference() == Altitude.Reference.HOME ? homeAmslMeters : 0))
                        .min()
                        .orElse(Double.POSITIVE_INFINITY)
                - UNDER_METERS;
    }

    /** Of a circle within which it stays the area is a little smaller, of one that it keeps out of a little larger. */
    private static List<Geodetic> corners(FenceArea shape) {
        if (shape instanceof FenceArea.Polygon polygon) {
            return polygon.corners();
        }
        FenceArea.Circle circle = (FenceArea.Circle) shape;
        double radius = circle.inside() ? circle.radiusMeters() : circle.radiusMeters() / Math.cos(Math.PI / CORNERS);
        LocalPlane plane = new LocalPlane(circle.center());
        List<Geodetic> corners = new ArrayList<>();
        for (int corner = 0; corner < CORNERS; corner++) {
            double angle = 2 * Math.PI * corner / CORNERS;
            corners.add(plane.place(new PlanePoint(radius * Math.sin(angle), radius * Math.cos(angle))));
        }
        return corners;
    }
}
