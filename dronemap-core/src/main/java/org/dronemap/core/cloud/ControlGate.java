package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiPredicate;
import org.dronemap.core.cloud.listener.CompositeUserPresence;
import org.dronemap.core.cloud.listener.UserPresence;
import org.dronemap.core.cloud.outlook.Outlook;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseStep;
import org.dronemap.core.time.Time;

/** The single entry point for users to take, request, hand over and release control of drones. Any thread. */
public final class ControlGate {
    private static final Duration LONGEST_WRITE = Duration.ofSeconds(10);

    private final DroneRegistry registry;
    private final CompositeUserPresence onlookers;
    private final Time time;

    ControlGate(DroneRegistry registry, CompositeUserPresence onlookers, Time time) {
        this.onlookers = onlookers;
        this.registry = registry;
        this.time = time;
    }

    /** From now on that is asked, too, whether a holder of whom nothing was heard is there. */
    public void watchedBy(UserPresence face) {
        onlookers.add(face);
    }

    /** Who commands a drone now; nobody when there is no such drone. */
    public ControlState control(DroneId drone) {
        return registry.find(drone).map(managed -> managed.control().control()).orElse(ControlState.FREE);
    }

    /** What becomes of a drone in the air when whoever has it has it no more; empty: it is not in the air, or not known. */
    public Optional<Outlook> outlook(DroneId drone) {
        return registry.find(drone).flatMap(managed -> Optional.ofNullable(managed.outlook()));
    }

    /**
     * Decides, and returns once the decision is durable.
     *
     * @throws UnknownDroneException when there is no such drone
     */
    public LeaseStep apply(DroneId drone, LeaseEvent event) {
        ManagedDrone managed = registry.find(drone).orElseThrow(() -> new UnknownDroneException(drone));
        DroneControl.Decision decision = managed.control().apply(event);
        Void unused = time.join(decision.durable(), LONGEST_WRITE);
        return decision.step();
    }

    /**
     * Everybody's control of that drone and wishes for it end, and what was said about it is not shown any more; returns once
     * that holds. Operations keep what they have.
     */
    public void clear(DroneId drone) {
        for (String user : control(drone).people()) {
            LeaseStep unused = apply(drone, new LeaseEvent.Expel(user));
        }
        registry.find(drone).ifPresent(managed -> {
            CompletableFuture<Void> forgotten = new CompletableFuture<>();
            managed.lane().execute(() -> {
                managed.forgetMessages();
                forgotten.complete(null);
            });
            Void unused = time.join(forgotten, LONGEST_WRITE);
        });
    }

    /** Takes control, or the wish for it, from those who may no longer command: every drone is asked about. Does not wait. */
    public void expelUnless(BiPredicate<String, DroneId> mayCommand) {
        for (ManagedDrone managed : registry.all()) {
            for (String user : managed.control().control().people()) {
                if (!mayCommand.test(user, managed.id())) {
                    managed.control().apply(new LeaseEvent.Expel(user));
                }
            }
        }
    }
}
