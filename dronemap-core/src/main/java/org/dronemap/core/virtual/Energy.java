package org.dronemap.core.virtual;

import java.util.Locale;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/**
 * What a tour takes out of a battery, estimated simply: the length of the way at a cruising speed, climbing, and waiting,
 * at so many per cent a minute. Both figures are assumed by kind, on the careful side, and stated wherever they count.
 */
public record Energy(double meters, double minutes, double percent, Draw draw) {
    private static final double CLIMB_METERS_PER_SECOND = 2;
    private static final double SECONDS_PER_MINUTE = 60;

    /** Assumed of a kind of vehicle. */
    public record Draw(double cruiseMetersPerSecond, double percentPerMinute) {
        static Draw of(VehicleKind kind) {
            return switch (kind) {
                case MULTICOPTER, HELICOPTER, UNKNOWN -> new Draw(5, 5);
                case FIXED_WING, VTOL -> new Draw(12, 2);
                case ROVER, BOAT, SUBMARINE, AIRSHIP -> new Draw(2, 1);
            };
        }
    }

    /** From where it stands over the waypoints from {@code first} on, and back unless it lands there. */
    static Energy of(Tour tour, int first, DroneState drone, Geodetic stand) {
        double meters = 0;
        double holds = 0;
        double climbs = 0;
        double height = 0;
        Geodetic at = stand;
        for (MissionItem.Waypoint waypoint :
                tour.waypoints().subList(first, tour.waypoints().size())) {
            double next = heightAboveHome(waypoint.altitude(), drone.home());
            meters += Geodesy.distanceMeters(at, waypoint.point());
            climbs += Math.abs(next - height);
            holds += waypoint.holdSeconds();
            height = next;
            at = waypoint.point();
        }
        meters += tour.landsThere() ? 0 : Geodesy.distanceMeters(at, stand);
        climbs += Math.abs(height);
        Draw draw = Draw.of(drone.identification().kind());
        double seconds = meters / draw.cruiseMetersPerSecond() + climbs / CLIMB_METERS_PER_SECOND + holds;
        double minutes = seconds / SECONDS_PER_MINUTE;
        return new Energy(meters, minutes, minutes * draw.percentPerMinute(), draw);
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

    /** "some 12 % for 2.4 km in 8.1 min (5 m/s and 5 % a minute assumed)". */
    String words() {
        return String.format(
                Locale.ROOT,
                "some %.0f %% for %.1f km in %.1f min (%.0f m/s and %.0f %% a minute assumed)",
                percent,
                meters / 1000,
                minutes,
                draw.cruiseMetersPerSecond(),
                draw.percentPerMinute());
    }
}
