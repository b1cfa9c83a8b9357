package org.dronemap.core.conduct;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.FlightPace;
import org.jspecify.annotations.Nullable;

/**
 * Remembers how fast drones were seen on missions, since vehicles do not say how fast they fly them, and how fast they
 * flew lately otherwise. One thread.
 */
final class SeenPaces {
    /** Whoever hovers may set off as fast as that. */
    private static final double LEAST_MANUAL = 3;
    /** With each look: what was seen half a minute ago counts half. */
    private static final double FORGETTING = 0.994;

    private final Map<DroneId, LastingSpeed> onMission = new HashMap<>();
    private final Map<DroneId, Double> lately = new HashMap<>();

    void observe(DroneState drone, @Nullable DroneFix fix) {
        if (fix == null) {
            return;
        }
        double speed = speed(drone, fix);
        lately.merge(drone.id(), speed, (before, now) -> Math.max(before * FORGETTING, now));
        boolean mission = drone.capabilities()
                .steering(drone.mode())
                .filter(by -> by == Steering.MISSION)
                .isPresent();
        if (mission) {
            onMission.computeIfAbsent(drone.id(), id -> new LastingSpeed()).observe(speed);
        } else {
            onMission.computeIfPresent(drone.id(), (id, seen) -> seen.interrupted());
        }
    }

    /** As it says itself: between two reports, each of which may be late, it seems to be as fast as anything. */
    private static double speed(DroneState drone, DroneFix fix) {
        Motion motion = drone.motion();
        Double said = motion == null ? null : motion.groundSpeed();
        return said == null ? Math.hypot(fix.eastward(), fix.northward()) : said;
    }

    /** Of one that flies a mission, or home. */
    FlightPace of(DroneState drone) {
        LastingSpeed seen = onMission.get(drone.id());
        return FlightPace.of(drone.identification()).atLeast(seen == null ? 0 : seen.highest());
    }

    /** Of one that somebody steers. */
    FlightPace manual(DroneState drone) {
        FlightPace usual = FlightPace.of(drone.identification());
        double cruise = Math.max(LEAST_MANUAL, lately.getOrDefault(drone.id(), 0.0));
        return new FlightPace(cruise, usual.climb(), usual.descent(), usual.acceleration());
    }

    void retainOnly(Set<DroneId> drones) {
        onMission.keySet().retainAll(drones);
        lately.keySet().retainAll(drones);
    }
}
