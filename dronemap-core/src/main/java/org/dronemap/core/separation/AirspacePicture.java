package org.dronemap.core.separation;

import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.function.BiPredicate;
import org.dronemap.core.command.Command;

/**
 * All drones at one moment, whoever flies them.
 *
 * @param drones in the order of their ids
 * @param least what is kept between any two of them
 * @param mayGo whether fences, zones and ceilings let a drone do that
 */
public record AirspacePicture(
        Instant now, List<TrackedDrone> drones, Separation least, BiPredicate<TrackedDrone, Command.GoTo> mayGo) {
    public AirspacePicture {
        drones = drones.stream()
                .sorted(Comparator.comparing(drone -> drone.id().value()))
                .toList();
    }
}
