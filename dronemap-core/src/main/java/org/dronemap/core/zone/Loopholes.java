package org.dronemap.core.zone;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Altitude;

/** What would lead a drone out of bounds later on, by ways that nobody can look at beforehand. */
final class Loopholes {
    private Loopholes() {}

    /** A sentence with {@code words} for the bounds; empty when this opens none. */
    static Optional<String> whyNot(List<Bounds> bounds, String words, DroneState drone, Command command) {
        if (command instanceof Command.SetParameters || command instanceof SetReturnHeight) {
            return Optional.of("Parameters say where a drone flies by itself, such as how high it comes home; within "
                    + words + " they cannot be written.");
        }
        if (command instanceof Command.SetHome && bounds.stream().anyMatch(Loopholes::isMeasuredFromHome)) {
            return Optional.of("The heights of " + words + " are measured from home; so home cannot be moved.");
        }
        if (command instanceof Command.SetMode mode && fliesItsOwnWay(drone, mode.mode())) {
            return Optional.of("Where it flies in " + mode.mode() + " is not known; so it cannot be checked against "
                    + words + ".");
        }
        return Optional.empty();
    }

    private static boolean isMeasuredFromHome(Bounds bounds) {
        return bounds.band().isBounded() && bounds.band().reference() == Altitude.Reference.HOME;
    }

    /** One that the vehicle does not have is refused for that. */
    private static boolean fliesItsOwnWay(DroneState drone, String mode) {
        return drone.capabilities().modes().contains(mode)
                && drone.capabilities().steering(mode).isEmpty();
    }
}
