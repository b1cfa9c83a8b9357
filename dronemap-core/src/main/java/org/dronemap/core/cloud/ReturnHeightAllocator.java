package org.dronemap.core.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.DoublePredicate;
import org.dronemap.core.cloud.rule.ReturnHeightChoice;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Allocates a return height to each drone in use, so that no two drones' ways home cross at one height. Any thread:
 * choices exclude each other, so that two drones that are armed at the same moment do not get the same height.
 */
final class ReturnHeightAllocator {
    private final DroneRegistry registry;
    private final Map<DroneId, Double> reserved = new ConcurrentHashMap<>();

    /**
     * The way home of one drone meets that of another.
     *
     * @param meters above home, at which it would fly there
     */
    record ReturnConflict(DroneState other, double meters) {}

    ReturnHeightAllocator(DroneRegistry registry) {
        this.registry = registry;
    }

    /** Chooses and reserves; empty when none is free, and then what its owner has set is reserved all the same. */
    synchronized OptionalDouble choose(DroneState drone, double owners, DoublePredicate allowed) {
        OptionalDouble chosen = ReturnHeightChoice.of(owners, occupiedHeights(drone), allowed);
        reserved.put(drone.id(), chosen.orElse(owners));
        return chosen;
    }

    synchronized void reserve(DroneId drone, double meters) {
        reserved.put(drone, meters);
    }

    synchronized void release(DroneId drone) {
        reserved.remove(drone);
    }

    /**
     * Another drone in the air that would come home as high as this one if both missed the cloud now, since one of them flies
     * above the height that was chosen for it; empty: there is none.
     */
    Optional<ReturnConflict> crossing(DroneState drone) {
        Double own = reserved.get(drone.id());
        if (own == null || !drone.airborne()) {
            return Optional.empty();
        }
        double mine = comesHomeAt(drone, own);
        DroneState found = null;
        for (Map.Entry<DroneId, Double> entry : reserved.entrySet()) {
            DroneState other = entry.getKey().equals(drone.id()) ? null : state(entry.getKey());
            if (other != null
                    && crosses(drone, mine, mine > own, other, entry.getValue())
                    && (found == null || other.id().value().compareTo(found.id().value()) < 0)) {
                found = other;
            }
        }
        return found == null ? Optional.empty() : Optional.of(new ReturnConflict(found, mine));
    }

    private @Nullable DroneState state(DroneId drone) {
        return registry.find(drone).map(found -> found.drone().state()).orElse(null);
    }

    /** Heights are compared first: each drone in the air asks this of all others. */
    private static boolean crosses(DroneState drone, double mine, boolean above, DroneState other, double others) {
        if (!other.airborne()) {
            return false;
        }
        double theirs = comesHomeAt(other, others);
        return (above || theirs > others)
                && !ReturnHeightChoice.areApart(mine, theirs + aboveGround(drone, other))
                && isNear(drone, other);
    }

    /** Above home: it climbs to its return height, and does not come down to it. */
    private static double comesHomeAt(DroneState drone, double reserved) {
        // It may have been told another one since, for an operation of several.
        double height = drone.returnHeight() == null
                ? reserved
                : Math.max(reserved, drone.returnHeight().meters());
        Position position = drone.position();
        Double now = position == null ? null : position.altitudeAboveHomeMeters();
        return now == null || !drone.airborne() ? height : Math.max(height, now);
    }

    private List<Double> occupiedHeights(DroneState drone) {
        List<Double> taken = new ArrayList<>();
        reserved.forEach((id, meters) -> registry.find(id)
                .map(other -> other.drone().state())
                .filter(other -> !id.equals(drone.id()) && isNear(drone, other))
                .ifPresent(other -> {
                    double above = aboveGround(drone, other);
                    taken.add(meters + above);
                    taken.add(comesHomeAt(other, meters) + above);
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
