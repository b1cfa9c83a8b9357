package org.dronemap.core.operation;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.jspecify.annotations.Nullable;

/**
 * What is seen of an operation's drones at one moment; a drone that was removed is not among them.
 *
 * @param sighted when the newest {@link Sighting} came; null: none came since the process began
 * @param unsteered drones that could not be steered, and why, as sentences
 */
public record Scene(
        Instant now, List<Seen> drones, @Nullable Instant sighted, Map<DroneId, String> unsteered) {
    public Scene {
        drones = List.copyOf(drones);
        unsteered = Map.copyOf(unsteered);
    }

    public Scene(Instant now, List<Seen> drones) {
        this(now, drones, null, Map.of());
    }

    public Optional<Seen> of(DroneId drone) {
        return drones.stream().filter(seen -> seen.state().id().equals(drone)).findFirst();
    }

    /**
     * One drone.
     *
     * @param takenBy why the operation has no control of it, as a sentence; null: it has
     * @param silence for how long nothing was heard, zero while its link is live
     * @param still for how long it has not moved from its place
     */
    public record Seen(DroneState state, @Nullable String takenBy, Duration silence, Duration still) {}
}
