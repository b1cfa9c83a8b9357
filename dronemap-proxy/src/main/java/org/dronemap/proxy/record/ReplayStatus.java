package org.dronemap.proxy.record;

import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * The status of one replay of a recording: its progress, drones, and counts of good and broken messages.
 *
 * @param records frames taken from it
 * @param goodMessages frames with a right checksum
 * @param brokenRuns places with bytes that belong to no frame, and how many bytes those are
 * @param progress 0 to 1, by bytes
 * @param failure a sentence when it could not be read to its end; null otherwise
 */
public record ReplayStatus(
        String id,
        String name,
        double speed,
        List<DroneId> drones,
        State state,
        long records,
        long goodMessages,
        long brokenRuns,
        long brokenBytes,
        double progress,
        @Nullable String failure) {
    public ReplayStatus {
        drones = List.copyOf(drones);
    }

    ReplayStatus withDrones(List<DroneId> now) {
        return new ReplayStatus(
                id, name, speed, now, state, records, goodMessages, brokenRuns, brokenBytes, progress, failure);
    }

    ReplayStatus cancelled() {
        return new ReplayStatus(
                id,
                name,
                speed,
                List.of(),
                State.CANCELLED,
                records,
                goodMessages,
                brokenRuns,
                brokenBytes,
                progress,
                failure);
    }

    /** The state of a replay between start and end. */
    public enum State {
        RUNNING,
        FINISHED,
        CANCELLED,
        FAILED
    }
}
