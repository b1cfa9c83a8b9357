package org.dronemap.core.zone;

import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/**
 * Elevations above sea level of a drone's home and ground, which heights of commands and bounds are measured from.
 *
 * @param homeAmslMeters null: not known
 * @param groundAmslMeters null: not known; then bounds are measured from home, too
 */
record HeightReferences(
        @Nullable Double homeAmslMeters, @Nullable Double groundAmslMeters) {
    /** Nearer than this they are one. */
    private static final double SAME_METERS = 0.5;

    static HeightReferences of(DroneState drone) {
        return new HeightReferences(homeAmslMeters(drone), drone.groundAmslMeters());
    }

    /** The height of home above the sea, also when only what is measured from it tells it. */
    private static @Nullable Double homeAmslMeters(DroneState drone) {
        Home home = drone.home();
        if (home != null) {
            return home.altitudeAmslMeters();
        }
        Position position = drone.position();
        Double amsl = position == null ? null : position.altitudeAmslMeters();
        Double above = position == null ? null : position.altitudeAboveHomeMeters();
        return amsl == null || above == null ? null : Double.valueOf(amsl - above);
    }

    /** What bounds "above home" are measured from. */
    private @Nullable Double zeroAmslMeters() {
        return groundAmslMeters == null ? homeAmslMeters : groundAmslMeters;
    }

    /** How far home is above what bounds are measured from; null: that cannot be said. */
    private @Nullable Double raisedMeters() {
        if (groundAmslMeters == null) {
            return 0.0;
        }
        return homeAmslMeters == null ? null : Double.valueOf(raised(homeAmslMeters - groundAmslMeters));
    }

    private static double raised(double meters) {
        return Math.abs(meters) <= SAME_METERS ? 0 : meters;
    }

    /** True when a home at that height is where bounds are measured from. */
    boolean isZero(double amslMeters) {
        Double zero = zeroAmslMeters();
        return zero != null && raised(amslMeters - zero) == 0;
    }

    /** A height that a vehicle is told, in metres above sea level; null: not known. */
    @Nullable
    Double amslMeters(Altitude altitude) {
        if (altitude.reference() == Altitude.Reference.AMSL) {
            return altitude.meters();
        }
        return homeAmslMeters == null ? null : Double.valueOf(homeAmslMeters + altitude.meters());
    }

    /** The same as a bound with that reference counts; null: not known. */
    @Nullable
    Double bounded(Altitude altitude, Altitude.Reference reference) {
        if (reference == Altitude.Reference.AMSL) {
            return amslMeters(altitude);
        }
        Double from = altitude.reference() == Altitude.Reference.HOME ? raisedMeters() : negative(zeroAmslMeters());
        return from == null ? null : Double.valueOf(altitude.meters() + from);
    }

    private static @Nullable Double negative(@Nullable Double meters) {
        return meters == null ? null : Double.valueOf(-meters);
    }

    /** Where it is now, as a bound with that reference counts; null: not known. */
    @Nullable
    Double bounded(Position position, Altitude.Reference reference) {
        Double amsl = position.altitudeAmslMeters();
        Double above = position.altitudeAboveHomeMeters();
        if (reference == Altitude.Reference.AMSL) {
            return amsl != null || above == null || homeAmslMeters == null
                    ? amsl
                    : Double.valueOf(above + homeAmslMeters);
        }
        Double raised = raisedMeters();
        Double zero = zeroAmslMeters();
        if (above != null && (amsl == null || zero == null || Double.valueOf(0).equals(raised))) {
            return raised == null ? null : Double.valueOf(above + raised);
        }
        return amsl == null || zero == null ? null : Double.valueOf(amsl - zero);
    }
}
