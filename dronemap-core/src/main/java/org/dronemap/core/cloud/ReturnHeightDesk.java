package org.dronemap.core.cloud;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Which drone flies home how high, from when that is chosen until its use is over. Any thread: choices exclude each other,
 * so that two drones that are armed at the same moment do not get the same height.
 */
final class ReturnHeightDesk {
    private final DroneRegistry registry;
    private final Map<DroneId, Double> reserved = new HashMap<>();

    ReturnHeightDesk(DroneRegistry registry) {
        this.registry = registry;
    }

    /** Chooses and reserves; empty when none is free, and then what its owner has set is reserved all the same. */
    synchronized OptionalDouble choose(DroneState drone, double owners, DoublePredicate allowed) {
        OptionalDouble chosen = ReturnHeightChoice.of(owners, taken(drone), allowed);
        reserved.put(drone.id(), chosen.orElse(owners));
        return chosen;
    }

    synchronized void reserve(DroneId drone, double meters) {
        reserved.put(drone, meters);
    }

    synchronized void release(DroneId drone) {
        reserved.remove(drone);
    }

    private List<Double> taken(DroneState drone) {
        List<Double> taken = new ArrayList<>();
        reserved.forEach((id, meters) -> registry.find(id)
                .map(other -> other.drone().state())
                .filter(other -> !id.equals(drone.id()) && isNear(drone, other))
                .ifPresent(other -> {
                    double above = aboveGround(drone, other);
                    taken.add(meters + above);
                    if (other.returnHeight() != null) {
                        // As it was told since, for an operation of several.
                        taken.add(other.returnHeight().meters() + above);
                    }
                }));
        return taken;
    }

    /** In doubt it is. */
    private static boolean isNear(DroneState one, DroneState other) {
        Geodetic here = place(one);
        Geodetic there = place(other);
        return here == null || there == null || Geodesy.distanceMeters(here, there) <= ReturnHeightChoice.NEAR_METERS;
    }

    private static @Nullable Geodetic place(DroneState drone) {
        Home home = drone.home();
        Position position = drone.position();
        return home != null ? home.point() : position == null ? null : position.point();
    }

    /** By how much the other's ground is above this one's; where one is not known, they are taken for level. */
    private static double aboveGround(DroneState drone, DroneState other) {
        Double here = drone.groundAmslMeters();
        Double there = other.groundAmslMeters();
        return here == null || there == null ? 0 : there - here;
    }
}
