package org.dronemap.core.conduct;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.VirtualDrone;

/**
 * Calls drones home that fell silent while they served, once they are heard again: others may fly their waypoints by now.
 * Owned by the conductor's thread.
 */
final class Recalls {
    private static final long BETWEEN_CALLS_NANOS = 5_000_000_000L;

    private final CloudManager cloud;
    private final VirtualBook book;
    private final DroneCrew crew;
    private final Time time;
    private final Map<DroneId, Long> calledNanos = new HashMap<>();

    Recalls(CloudManager cloud, VirtualBook book, DroneCrew crew, Time time) {
        this.cloud = cloud;
        this.book = book;
        this.crew = crew;
        this.time = time;
    }

    void goOn(VirtualDrone drone) {
        for (DroneId id : drone.recalled()) {
            Optional<DroneState> state = cloud.drone(id);
            if (state.isEmpty() || crew.takenBy(VirtualHolder.of(drone), id) != null) {
                over(drone, id);
            } else if (state.get().link().state() == LinkState.LIVE
                    && state.get().capabilities().known()) {
                call(drone, state.get());
            }
        }
    }

    private void call(VirtualDrone drone, DroneState state) {
        boolean onItsWay = state.capabilities().steering(state.mode()).equals(Optional.of(Steering.SAFETY));
        if (Boolean.FALSE.equals(state.armed()) || onItsWay) {
            over(drone, state.id());
            crew.release(VirtualHolder.of(drone), state.id());
            return;
        }
        long now = time.nanos();
        Long called = calledNanos.get(state.id());
        if (called == null || now - called > BETWEEN_CALLS_NANOS) {
            calledNanos.put(state.id(), now);
            crew.command(
                    VirtualHolder.of(drone),
                    state.id(),
                    new CommandId(time.newId()),
                    state.airborne() ? new Command.ReturnToLaunch() : new Command.Disarm(false));
        }
    }

    private void over(VirtualDrone drone, DroneId id) {
        calledNanos.remove(id);
        book.find(drone.id()).ifPresent(now -> book.put(now.home(id)));
    }
}
