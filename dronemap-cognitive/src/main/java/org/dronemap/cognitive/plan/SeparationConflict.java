package org.dronemap.cognitive.plan;

import java.util.Locale;
import org.dronemap.core.drone.DroneId;

/** A conflict in a plan: two drones in the air come nearer to each other than the least separation. */
public record SeparationConflict(DroneId one, DroneId other, double seconds, double horizontalMeters) {
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
