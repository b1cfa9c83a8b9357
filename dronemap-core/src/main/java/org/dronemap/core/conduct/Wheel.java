package org.dronemap.core.conduct;

import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.Holder;
import org.dronemap.core.operation.Guide;
import org.dronemap.core.operation.Scene;
import org.dronemap.core.operation.Sighting;
import org.jspecify.annotations.Nullable;

/** Hands what the guide of one operation says to the gate for setpoints. Owned by the conductor's thread, but for {@link #sighted}. */
final class Wheel<S> {
    /** Between two turns of the conductor some few come. */
    private static final int MOST_WAITING = 64;

    private final DroneCrew crew;
    private final Holder.Operation holder;
    private final Guide<S> guide;
    private final BlockingQueue<Sighting> sightings = new ArrayBlockingQueue<>(MOST_WAITING);
    private final Map<DroneId, String> refusals = new HashMap<>();
    private Set<DroneId> steered = Set.of();
    private @Nullable Instant heard;

    Wheel(DroneCrew crew, Holder.Operation holder, Guide<S> guide) {
        this.crew = crew;
        this.holder = holder;
        this.guide = guide;
    }

    /** False when too many wait already. Any thread. */
    boolean sighted(Sighting sighting) {
        return sightings.offer(sighting);
    }

    /** Tells the guide what came in, and the gate what the guide says; the scene with what became of it. */
    Scene turn(S state, Scene scene) {
        for (Sighting one = sightings.poll(); one != null; one = sightings.poll()) {
            guide.sighted(one);
            heard = heard == null || one.heard().isAfter(heard) ? one.heard() : heard;
        }
        Scene now = new Scene(scene.now(), scene.drones(), heard, Map.of());
        Map<DroneId, Setpoint> said = guide.steer(state, now);
        refusals.clear();
        said.forEach(
                (drone, setpoint) -> crew.steer(holder, drone, setpoint).ifPresent(why -> refusals.put(drone, why)));
        letGo(said.keySet());
        return new Scene(scene.now(), scene.drones(), heard, refusals);
    }

    /** Of all others at once: they stand still. */
    void letGo(Set<DroneId> but) {
        Set<DroneId> others = new HashSet<>(steered);
        others.removeAll(but);
        steered = Set.copyOf(but);
        others.forEach(drone -> crew.letGo(holder, drone));
    }
}
