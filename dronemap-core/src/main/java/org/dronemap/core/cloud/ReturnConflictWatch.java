package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.Locale;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.jspecify.annotations.Nullable;

/**
 * Warns when one drone flies so high that on loss of the cloud it would fly home at the height of another drone. On the
 * drone's lane.
 */
final class ReturnConflictWatch {
    private static final long RHYTHM_NANOS = Duration.ofSeconds(5).toNanos();

    private final ManagedDrone drone;
    private final ReturnHeightAllocator heights;
    private long lookedNanos;
    private @Nullable DroneId seen;
    private boolean warned;

    ReturnConflictWatch(ManagedDrone drone, ReturnHeightAllocator heights) {
        this.drone = drone;
        this.heights = heights;
        this.lookedNanos = drone.lane().activeNanos();
    }

    void update() {
        long nanos = drone.lane().activeNanos();
        if (nanos - lookedNanos < RHYTHM_NANOS) {
            return;
        }
        lookedNanos = nanos;
        ReturnHeightAllocator.ReturnConflict now =
                heights.crossing(drone.drone().state()).orElse(null);
        DroneId before = seen;
        seen = now == null ? null : now.other().id();
        if (now == null || !now.other().id().equals(before)) {
            // One that climbs past another's height is there for a moment only.
            warned = false;
        } else if (!warned) {
            warned = true;
            drone.publishMessage(Severity.WARNING, words(now));
        }
    }

    private static String words(ReturnHeightAllocator.ReturnConflict now) {
        return String.format(
                Locale.ROOT,
                "Without the cloud it would now fly home at %.0f m, as high as %s: their ways home may cross.",
                now.meters(),
                now.other().name());
    }
}
