package org.dronemap.core.conduct;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseHolder;
import org.jspecify.annotations.Nullable;

/**
 * Takes and releases control of the drones of one operation; asks once for each drone. Control is asked for once, when
 * a drone comes: whoever takes it afterwards keeps it. Drones are asked for and released in the order in which the
 * operation names them, which is the same in each process. Owned by the conductor's thread.
 */
final class OperationLeases {
    private final DroneGateway crew;
    private final LeaseHolder.Operation holder;
    private Set<DroneId> wanted = Set.of();

    OperationLeases(DroneGateway crew, LeaseHolder.Operation holder) {
        this.crew = crew;
        this.holder = holder;
    }

    /** All of them or none, and why. */
    Optional<Operations.NoControl> acquireAll(Set<DroneId> drones) {
        for (DroneId drone : drones) {
            Optional<String> why = crew.engage(holder, drone);
            if (why.isPresent()) {
                release(List.copyOf(drones));
                return Optional.of(new Operations.NoControl(drone, "The drone " + drone + ": " + why.get()));
            }
        }
        wanted = new LinkedHashSet<>(drones);
        return Optional.empty();
    }

    /** Asks for those that were not wanted before; nothing is given back yet. */
    void acquire(Set<DroneId> drones) {
        Set<DroneId> all = new LinkedHashSet<>(wanted);
        for (DroneId drone : drones) {
            if (all.add(drone)) {
                // Whoever has it is seen in the next scene.
                Optional<String> unused = crew.engage(holder, drone);
            }
        }
        wanted = all;
    }

    /** Gives back all others. */
    void retainOnly(Set<DroneId> drones) {
        List<DroneId> others =
                wanted.stream().filter(drone -> !drones.contains(drone)).toList();
        wanted = new LinkedHashSet<>(drones);
        release(others);
    }

    /** To the user of the operation. */
    void handOver(DroneId drone) {
        crew.handOver(holder, drone);
    }

    boolean isRequested(DroneId drone) {
        return wanted.contains(drone);
    }

    /** Why there is no control of it, as a sentence; null: there is. */
    @Nullable
    String whyNotHeld(DroneId drone) {
        return crew.whyNotHeld(holder, drone);
    }

    private void release(List<DroneId> drones) {
        drones.forEach(drone -> crew.release(holder, drone));
    }
}
