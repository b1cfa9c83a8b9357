package org.dronemap.core.zone;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/**
 * What a geometry library thinks of a mission, on the plane that touches the ellipsoid in the middle of each leg: its
 * own projection, its own walk through the mission, its own heights. Nothing here comes from what it judges.
 */
final class ExactZoneOracle {
    private static final GeometryFactory SHAPES = new GeometryFactory();

    private final DroneState drone;

    /** How near the mission comes to what it must not touch, in metres; 0 and less when it does. */
    record Expectation(boolean touches, double clearByMeters) {}

    private record Part(Geodetic from, Geodetic to, double low, double high) {}

    ExactZoneOracle(DroneState drone) {
        this.drone = drone;
    }

    Expectation judge(Command command, List<Zone> zones) {
        boolean touches = false;
        double clear = Double.POSITIVE_INFINITY;
        for (Part part : parts(command)) {
            for (Zone zone : zones) {
                double room = zone.shape().inside() ? stay(part, zone) : avoid(part, zone);
                touches |= room <= 0;
                clear = Math.min(clear, room);
            }
        }
        return new Expectation(touches, clear);
    }

    /** All heights above the sea. */
    private List<Part> parts(Command command) {
        double zero = drone.home().altitudeAmslMeters();
        Geodetic here = drone.position().point();
        if (command instanceof Command.GoTo goTo) {
            double now = drone.position().altitudeAmslMeters();
            double then = aboveTheSea(goTo.altitude(), zero);
            return List.of(new Part(here, goTo.point(), Math.min(now, then), Math.max(now, then)));
        }
        if (command instanceof Command.TakeOff takeOff) {
            return List.of(new Part(here, here, -1e9, zero + takeOff.altitudeMeters()));
        }
        return parts(((Command.UploadMission) command).mission());
    }

    private static double aboveTheSea(Altitude altitude, double zero) {
        return altitude.reference() == Altitude.Reference.AMSL ? altitude.meters() : zero + altitude.meters();
    }

    private List<Part> parts(Mission mission) {
        Home home = drone.home();
        double zero = home.altitudeAmslMeters();
        List<Part> parts = new ArrayList<>();
        Geodetic at = drone.position().point();
        double height = zero;
        for (MissionItem item : mission.items()) {
            if (item instanceof MissionItem.TakeOff takeOff) {
                height = zero + takeOff.altitudeMeters();
                parts.add(new Part(at, at, -1e9, height));
            } else if (item instanceof MissionItem.Waypoint waypoint) {
                double next = aboveTheSea(waypoint.altitude(), zero);
                parts.add(new Part(at, waypoint.point(), Math.min(height, next), Math.max(height, next)));
                at = waypoint.point();
                height = next;
            } else if (item instanceof MissionItem.ReturnToLaunch) {
                double over = Math.max(height, zero + 60);
                parts.add(new Part(at, home.point(), Math.min(height, zero + 60), over));
                parts.add(new Part(home.point(), home.point(), -1e9, over));
            } else {
                parts.add(new Part(at, at, -1e9, height));
            }
        }
        return parts;
    }

    /** The room between a part and a keep-out: sideways, or above or below it. */
    private double avoid(Part part, Zone zone) {
        double sideways = distance(part, zone.shape());
        double under = low(zone) - part.high();
        double over = part.low() - high(zone);
        return Math.max(sideways, Math.max(under, over));
    }

    /** The room that is left inside: to the edge and to the ceiling. */
    private double stay(Part part, Zone zone) {
        return Math.min(depth(part, zone.shape()), Math.nextUp(high(zone) - part.high()));
    }

    private double low(Zone zone) {
        return zone.band().lowMeters() + shift(zone);
    }

    private double high(Zone zone) {
        return zone.band().highMeters() + shift(zone);
    }

    private double shift(Zone zone) {
        return zone.band().reference() == Altitude.Reference.HOME ? drone.home().altitudeAmslMeters() : 0;
    }

    private static double distance(Part part, FenceArea shape) {
        Tangent plane = new Tangent(part);
        Geometry way = plane.line(part);
        if (shape instanceof FenceArea.Circle circle) {
            return way.distance(plane.point(circle.center())) - circle.radiusMeters();
        }
        Polygon area = plane.area((FenceArea.Polygon) shape);
        return area.intersects(way) ? 0 : area.distance(way);
    }

    private static double depth(Part part, FenceArea shape) {
        Tangent plane = new Tangent(part);
        Geometry way = plane.line(part);
        if (shape instanceof FenceArea.Circle circle) {
            Geometry center = plane.point(circle.center());
            double farthest =
                    Math.max(center.distance(plane.point(part.from())), center.distance(plane.point(part.to())));
            return circle.radiusMeters() - farthest;
        }
        Polygon area = plane.area((FenceArea.Polygon) shape);
        return area.contains(way) ? area.getExteriorRing().distance(way) : 0;
    }

    /** East and north on the plane that touches the ellipsoid there, by way of the centre of the Earth. */
    private static final class Tangent {
        private static final double A = 6_378_137.0;
        private static final double F = 1 / 298.257_223_563;
        private static final double E2 = F * (2 - F);

        private final double latitude;
        private final double longitude;
        private final double[] origin;

        Tangent(Part part) {
            double east = part.to().longitudeDegrees() - part.from().longitudeDegrees();
            double shortWay = east - 360 * Math.rint(east / 360);
            latitude = Math.toRadians((part.from().latitudeDegrees() + part.to().latitudeDegrees()) / 2);
            longitude = Math.toRadians(part.from().longitudeDegrees() + shortWay / 2);
            origin = fromCentre(latitude, longitude);
        }

        private static double[] fromCentre(double latitude, double longitude) {
            double n = A / Math.sqrt(1 - E2 * Math.sin(latitude) * Math.sin(latitude));
            return new double[] {
                n * Math.cos(latitude) * Math.cos(longitude),
                n * Math.cos(latitude) * Math.sin(longitude),
                n * (1 - E2) * Math.sin(latitude)
            };
        }

        Coordinate spot(Geodetic place) {
            double[] p = fromCentre(Math.toRadians(place.latitudeDegrees()), Math.toRadians(place.longitudeDegrees()));
            double x = p[0] - origin[0];
            double y = p[1] - origin[1];
            double z = p[2] - origin[2];
            return new Coordinate(
                    -Math.sin(longitude) * x + Math.cos(longitude) * y,
                    -Math.sin(latitude) * Math.cos(longitude) * x
                            - Math.sin(latitude) * Math.sin(longitude) * y
                            + Math.cos(latitude) * z);
        }

        Geometry point(Geodetic place) {
            return SHAPES.createPoint(spot(place));
        }

        Geometry line(Part part) {
            return part.from().equals(part.to())
                    ? point(part.from())
                    : SHAPES.createLineString(new Coordinate[] {spot(part.from()), spot(part.to())});
        }

        Polygon area(FenceArea.Polygon shape) {
            List<Coordinate> ring = new ArrayList<>();
            shape.corners().forEach(corner -> ring.add(spot(corner)));
            ring.add(ring.get(0));
            return SHAPES.createPolygon(ring.toArray(Coordinate[]::new));
        }
    }
}
