package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.Locale;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.jspecify.annotations.Nullable;

/**
 * Warns when one drone flies so high above its return height that without the cloud it would come home as high as another near
 * it: heights to return at are chosen on the ground, when nobody knows yet how high it will fly. On the drone's lane.
 */
final class ReturnCrossing {
    private static final long RHYTHM_NANOS = Duration.ofSeconds(5).toNanos();

    private final ManagedDrone drone;
    private final ReturnHeightDesk heights;
    private long lookedNanos;
    private @Nullable DroneId seen;
    private boolean told;

    ReturnCrossing(ManagedDrone drone, ReturnHeightDesk heights) {
        this.drone = drone;
        this.heights = heights;
        this.lookedNanos = drone.lane().activeNanos();
    }

    void look() {
        long now = drone.lane().activeNanos();
        if (now - lookedNanos < RHYTHM_NANOS) {
            return;
        }
        lookedNanos = now;
        DroneState state = drone.drone().state();
        DroneState other = heights.crossing(state).orElse(null);
        DroneId before = seen;
        seen = other == null ? null : other.id();
        if (other == null || !other.id().equals(before)) {
            // Who climbs past another's height is there for a moment only.
            told = false;
        } else if (!told) {
            told = true;
            drone.say(Severity.WARNING, words(state, other));
        }
    }

    private static String words(DroneState state, DroneState other) {
        Position position = state.position();
        Double height = position == null ? null : position.altitudeAboveHomeMeters();
        return "Without the cloud it would now fly home as high as " + other.name()
                + (height == null ? "" : String.format(Locale.ROOT, " (it flies at %.0f m)", height))
                + ": their ways home may cross.";
    }
}
