package org.dronemap.cognitive.plan;

import java.util.Locale;
import org.dronemap.core.drone.DroneId;

/** Two drones in the air come too near to each other. */
public record Conflict(DroneId one, DroneId other, double seconds, double horizontalMeters) {
    public String words() {
        return String.format(
                Locale.ROOT,
                "The drones %s and %s are %.1f m apart after %.0f s, at heights that are not kept apart.",
                one,
                other,
                horizontalMeters,
                seconds);
    }
}
