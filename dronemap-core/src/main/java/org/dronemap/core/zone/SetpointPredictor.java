package org.dronemap.core.zone;

import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/** Predicts where a setpoint leads one drone within seconds, so that it can be checked against zones. Immutable. */
final class SetpointPredictor {
    /** For so long it goes on, and then stands, whatever is said later: reaction and braking of fast copters. */
    private static final double AHEAD_SECONDS = 3;
    /** What copters make of a stick at its end, as they come. */
    private static final double STICK_METERS_PER_SECOND = 5;

    private static final double STICK_CLIMB_METERS_PER_SECOND = 2.5;
    private static final double FASTEST = 100;
    /** Where that is on the Earth, nobody knows. */
    private static final Command SOMEWHERE = new GoToLocal(0, 0, null);

    private final DroneState drone;
    private final @Nullable Position position;

    SetpointPredictor(DroneState drone) {
        this.drone = drone;
        this.position = drone.position();
    }

    Optional<Command> of(Setpoint setpoint) {
        return switch (setpoint.kind()) {
            case TRACK -> Optional.of(ahead((Setpoint.Track) setpoint));
            case VELOCITY -> ahead((Setpoint.Velocity) setpoint);
            case STICKS -> ahead((Setpoint.Sticks) setpoint);
        };
    }

    private Optional<Command> ahead(Setpoint.Velocity velocity) {
        Geodetic here = here();
        return here == null || turnsUnknown(velocity) ? Optional.of(SOMEWHERE) : ahead(here, velocity);
    }

    private Optional<Command> ahead(Setpoint.Sticks sticks) {
        Geodetic here = here();
        return here == null ? Optional.empty() : ahead(here, meant(sticks));
    }

    private Optional<Command> ahead(Geodetic here, Setpoint.Velocity wanted) {
        Altitude altitude = altitude(-wanted.down() * AHEAD_SECONDS);
        return altitude == null
                ? Optional.empty()
                : Optional.of(new Command.GoTo(new LocalPlane(here).place(moved(wanted)), altitude));
    }

    private @Nullable Geodetic here() {
        return position == null ? null : position.point();
    }

    /** Whoever hears nothing more goes on as the place moved, and then stands. */
    private Command ahead(Setpoint.Track track) {
        Setpoint.Velocity moving = track.moving();
        if (moving == null) {
            return new Command.GoTo(track.point(), track.altitude());
        }
        Altitude altitude = track.altitude();
        double meters = altitude.meters() - moving.down() * AHEAD_SECONDS;
        return new Command.GoTo(
                new LocalPlane(track.point()).place(moved(moving)),
                Math.abs(meters) <= Altitude.HIGHEST_PLANNED_METERS
                        ? new Altitude(meters, altitude.reference())
                        : altitude);
    }

    private boolean turnsUnknown(Setpoint.Velocity velocity) {
        return velocity.frame() == Setpoint.Frame.VEHICLE
                && heading() == null
                && (velocity.forward() != 0 || velocity.right() != 0);
    }

    /** Sticks say where to; how fast, the vehicle's own settings say. */
    private Setpoint.Velocity meant(Setpoint.Sticks sticks) {
        double deflection = Math.hypot(sticks.forward(), sticks.right());
        double speed = deflection == 0 ? 0 : Math.max(speed(), deflection * STICK_METERS_PER_SECOND) / deflection;
        return new Setpoint.Velocity(
                Setpoint.Frame.VEHICLE,
                sticks.forward() * Math.min(FASTEST, speed),
                sticks.right() * Math.min(FASTEST, speed),
                -sticks.up() * STICK_CLIMB_METERS_PER_SECOND,
                Setpoint.Facing.ANY);
    }

    private PlanePoint moved(Setpoint.Velocity velocity) {
        Double heading = velocity.frame() == Setpoint.Frame.EARTH ? Double.valueOf(0) : heading();
        double turned = Math.toRadians(heading == null ? 0 : heading);
        double north = velocity.forward() * Math.cos(turned) - velocity.right() * Math.sin(turned);
        double east = velocity.forward() * Math.sin(turned) + velocity.right() * Math.cos(turned);
        return new PlanePoint(east * AHEAD_SECONDS, north * AHEAD_SECONDS);
    }

    private double speed() {
        Motion motion = drone.motion();
        Double speed = motion == null ? null : motion.groundSpeed();
        return speed == null ? 0 : speed;
    }

    private @Nullable Double heading() {
        Motion motion = drone.motion();
        return motion == null ? null : motion.headingDegrees();
    }

    private @Nullable Altitude altitude(double rise) {
        for (Altitude known : MissionRouteBuilder.altitudes(position)) {
            double meters = known.meters() + rise;
            return Math.abs(meters) <= Altitude.HIGHEST_PLANNED_METERS
                    ? new Altitude(meters, known.reference())
                    : known;
        }
        return null;
    }
}
