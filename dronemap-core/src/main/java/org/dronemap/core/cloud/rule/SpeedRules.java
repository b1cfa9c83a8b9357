package org.dronemap.core.cloud.rule;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.VehicleKind;

/** Rules for changing a drone's speed: the bounds of its kind, and the modes in which it goes by one. */
final class SpeedRules {
    /** Wings carry nothing slower. */
    private static final Bounds WINGS = new Bounds(3, ChangeSpeed.FASTEST);
    /** Autopilots of copters take slower ones and do nothing with them. */
    private static final Bounds ROTORS = new Bounds(0.2, 30);

    private static final Bounds WHEELS = new Bounds(ChangeSpeed.SLOWEST, 30);
    private static final Bounds ANY = new Bounds(ChangeSpeed.SLOWEST, ChangeSpeed.FASTEST);

    /** In m/s, both allowed. */
    private record Bounds(double slowest, double fastest) {}

    private SpeedRules() {}

    static Optional<Refusal> whyNot(DroneState drone, ChangeSpeed wanted) {
        VehicleKind kind = drone.identification().kind();
        Bounds bounds = bounds(kind);
        double speed = wanted.metersPerSecond();
        if (speed < bounds.slowest() || speed > bounds.fastest()) {
            return Optional.of(new Refusal(
                    OutcomeCode.SPEED_NOT_POSSIBLE,
                    String.format(
                            Locale.ROOT,
                            "metersPerSecond must be %s to %s for a vehicle of this kind (%s), not %s.",
                            number(bounds.slowest()),
                            number(bounds.fastest()),
                            kind.name().toLowerCase(Locale.ROOT).replace('_', ' '),
                            number(speed))));
        }
        return modeForbids(drone);
    }

    private static Bounds bounds(VehicleKind kind) {
        return switch (kind) {
            case FIXED_WING -> WINGS;
            case MULTICOPTER, HELICOPTER, SUBMARINE -> ROTORS;
            case ROVER, BOAT -> WHEELS;
            case VTOL, AIRSHIP, UNKNOWN -> ANY;
        };
    }

    /** Where the drone goes by sticks, home or down it takes the speed of that. */
    private static Optional<Refusal> modeForbids(DroneState drone) {
        Capabilities can = drone.capabilities();
        Optional<Steering> by = can.steering(drone.mode());
        if (by.isEmpty() || by.get() == Steering.ORDERS || by.get() == Steering.MISSION) {
            return Optional.empty();
        }
        List<String> modes =
                Optional.of(Steering.ORDERS).flatMap(can::mode).stream().toList();
        String way = modes.isEmpty() ? "." : "; change its mode to " + String.join(" or ", modes) + " first.";
        return Optional.of(new Refusal(
                OutcomeCode.MODE_NOT_STEERABLE, "In " + drone.mode() + " it does not go by such a speed" + way));
    }

    private static String number(double value) {
        return value == Math.rint(value) ? String.valueOf(Math.round(value)) : String.valueOf(value);
    }
}
