package org.dronemap.core.conduct;

import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.operation.Scene;
import org.jspecify.annotations.Nullable;

/** What operations see of their drones. Owned by the conductor's thread. */
final class Scenery {
    private final CloudManager cloud;
    private final OperationRights rights;
    private final Clock clock;
    private final Silence silence;
    private final Stillness stillness;

    Scenery(CloudManager cloud, OperationRights rights, Clock clock, LongSupplier nanoTime) {
        this.cloud = cloud;
        this.rights = rights;
        this.clock = clock;
        this.silence = new Silence(nanoTime);
        this.stillness = new Stillness(nanoTime);
    }

    /** In the order of their ids. */
    Scene of(String owner, Reins reins, Set<DroneId> drones) {
        TreeMap<String, DroneState> states = new TreeMap<>();
        drones.forEach(id -> cloud.drone(id).ifPresent(state -> states.put(id.value(), state)));
        List<Scene.Seen> seen = new ArrayList<>();
        for (DroneState state : states.values()) {
            seen.add(new Scene.Seen(state, takenBy(owner, reins, state.id()), silence.of(state), stillness.of(state)));
        }
        return new Scene(clock.instant(), seen);
    }

    private @Nullable String takenBy(String owner, Reins reins, DroneId drone) {
        String taken = reins.takenBy(drone);
        return taken != null ? taken : rights.whyNot(owner, drone).orElse(null);
    }
}
