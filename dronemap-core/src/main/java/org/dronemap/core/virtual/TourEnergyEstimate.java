package org.dronemap.core.virtual;

import java.util.Locale;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/**
 * Estimates time and battery that a drone needs for a tour, from its length, climbs, waits and wind. Both figures are
 * assumed by kind, on the careful side, and stated wherever they count. Where the wind is known it counts on each leg.
 *
 * @param minutes infinite: it makes no headway on one of its legs
 * @param wind null: not known
 */
public record TourEnergyEstimate(
        double meters,
        double minutes,
        double percent,
        Draw draw,
        @Nullable Wind wind) {
    private static final double CLIMB_METERS_PER_SECOND = 2;
    private static final double SECONDS_PER_MINUTE = 60;
    private static final double CALM = 0.5;

    /**
     * Assumed of a kind of vehicle.
     *
     * @param fastestThroughAir m/s; up to it the wind does not slow it down, and none of it carries it along; infinite: the wind
     *     is nothing to it
     */
    public record Draw(double cruiseMetersPerSecond, double percentPerMinute, double fastestThroughAir) {
        private static final double LEAST_HEADWAY = 0.5;

        static Draw of(VehicleKind kind) {
            return switch (kind) {
                case MULTICOPTER, HELICOPTER, UNKNOWN -> new Draw(5, 5, 10);
                case FIXED_WING, VTOL -> new Draw(12, 2, 12);
                case AIRSHIP -> new Draw(2, 1, 2);
                case ROVER, BOAT, SUBMARINE -> new Draw(2, 1, Double.POSITIVE_INFINITY);
            };
        }

        /** Seconds from one place to another; infinite when the wind is too strong for that. */
        double seconds(Geodetic from, Geodetic to, @Nullable Wind wind) {
            double meters = Geodesy.distanceMeters(from, to);
            if (wind == null || meters == 0 || Double.isInfinite(fastestThroughAir)) {
                return meters / cruiseMetersPerSecond;
            }
            PlanePoint way = LocalPlane.offset(from, to);
            double blowsTo = Math.toRadians(wind.fromDegrees() + 180);
            double angle = blowsTo - Math.atan2(way.eastMeters(), way.northMeters());
            double across = wind.metersPerSecond() * Math.sin(angle);
            double along = wind.metersPerSecond() * Math.cos(angle);
            double ahead = Math.abs(across) < fastestThroughAir
                    ? Math.sqrt(fastestThroughAir * fastestThroughAir - across * across) + along
                    : 0;
            // Aeroplanes are carried along; copters hold their speed over the ground.
            double overGround =
                    fastestThroughAir > cruiseMetersPerSecond ? Math.min(cruiseMetersPerSecond, ahead) : ahead;
            return overGround < LEAST_HEADWAY ? Double.POSITIVE_INFINITY : meters / overGround;
        }
    }

    /** From where it stands over the waypoints from {@code first} on, and back unless it lands there. */
    static TourEnergyEstimate of(VirtualTour tour, int first, DroneState drone, Geodetic stand, @Nullable Wind wind) {
        Draw draw = Draw.of(drone.identification().kind());
        double meters = 0;
        double seconds = 0;
        double holds = 0;
        double climbs = 0;
        double height = 0;
        Geodetic at = stand;
        for (MissionItem.Waypoint waypoint :
                tour.waypoints().subList(first, tour.waypoints().size())) {
            double next = heightAboveHome(waypoint.altitude(), drone.home());
            meters += Geodesy.distanceMeters(at, waypoint.point());
            seconds += draw.seconds(at, waypoint.point(), wind);
            climbs += Math.abs(next - height);
            holds += waypoint.holdSeconds();
            height = next;
            at = waypoint.point();
        }
        if (!tour.landsThere()) {
            meters += Geodesy.distanceMeters(at, stand);
            seconds += draw.seconds(at, stand, wind);
        }
        climbs += Math.abs(height);
        double minutes = (seconds + climbs / CLIMB_METERS_PER_SECOND + holds) / SECONDS_PER_MINUTE;
        return new TourEnergyEstimate(meters, minutes, minutes * draw.percentPerMinute(), draw, wind);
    }

    private static double heightAboveHome(Altitude altitude, @Nullable Home home) {
        return altitude.reference() == Altitude.Reference.AMSL && home != null
                ? altitude.meters() - home.altitudeAmslMeters()
                : altitude.meters();
    }

    /** For how many minutes that charge lasts. */
    public static double minutesOf(double percent, VehicleKind kind) {
        return percent / Draw.of(kind).percentPerMinute();
    }

    /** "some 12 % for 2.4 km in 8.1 min (5 m/s and 5 % a minute assumed; a wind of 6 m/s from 270°, as felt in the air)". */
    String words() {
        return String.format(
                Locale.ROOT,
                "some %.0f %% for %.1f km in %.1f min (%.0f m/s and %.0f %% a minute assumed%s)",
                percent,
                meters / 1000,
                minutes,
                draw.cruiseMetersPerSecond(),
                draw.percentPerMinute(),
                felt());
    }

    private String felt() {
        if (wind == null) {
            return "";
        }
        return wind.metersPerSecond() < CALM
                ? "; no wind, as felt in the air"
                : String.format(
                        Locale.ROOT,
                        "; a wind of %.0f m/s from %.0f°, as felt in the air",
                        wind.metersPerSecond(),
                        wind.fromDegrees());
    }
}
