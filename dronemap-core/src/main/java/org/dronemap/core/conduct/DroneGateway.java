package org.dronemap.core.conduct;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.jspecify.annotations.Nullable;

/**
 * Takes and releases control of drones for operations and virtual drones, and sends their commands and setpoints. Any
 * thread.
 */
final class DroneGateway {
    private final CloudManager cloud;
    private final String face;
    private final Set<DroneId> steeredDrones = ConcurrentHashMap.newKeySet();

    /** {@code face}: the way in that its commands come by. */
    DroneGateway(CloudManager cloud, String face) {
        this.cloud = cloud;
        this.face = face;
    }

    /** Why control cannot be had, as a sentence; empty when it is there. */
    Optional<String> engage(LeaseHolder.Operation by, DroneId drone) {
        try {
            LeaseAnswer answer =
                    cloud.controls().apply(drone, new LeaseEvent.Engage(by)).answer();
            return answer instanceof LeaseAnswer.Denied denied ? Optional.of(denied.why()) : Optional.empty();
        } catch (UnknownDroneException removed) {
            return Optional.of("There is no such drone any more.");
        }
    }

    void release(LeaseHolder.Operation by, DroneId drone) {
        if (cloud.drone(drone).isPresent()) {
            cloud.controls().apply(drone, new LeaseEvent.Disengage(by.id()));
        }
    }

    /** Control goes over to the user of this one. */
    void handOver(LeaseHolder.Operation by, DroneId drone) {
        if (cloud.drone(drone).isPresent()) {
            cloud.controls().apply(drone, new LeaseEvent.Disengage(by.id(), by.user()));
        }
    }

    /** Why this one does not have control, as a sentence; null: it has. */
    @Nullable
    String whyNotHeld(LeaseHolder.Operation by, DroneId drone) {
        ControlState control = cloud.controls().control(drone);
        boolean has = control.tenure() != null && control.tenure().holder().isOperation(by.id());
        if (has) {
            return null;
        }
        return control.interruption() == null ? control.sentence() : control.interruption();
    }

    /** Somebody, or something, has control. */
    Optional<String> whyBusy(DroneId drone) {
        ControlState control = cloud.controls().control(drone);
        return control.tenure() == null ? Optional.empty() : Optional.of(control.sentence());
    }

    /** What the gate would say. */
    Optional<Refusal> refusal(LeaseHolder.Operation by, DroneState drone, Command command) {
        return cloud.gate().whyNot(principal(by), drone, command);
    }

    void command(LeaseHolder.Operation by, DroneId drone, CommandId id, Command command) {
        cloud.gate().submit(source(by), drone, id, command);
    }

    /** Why it cannot be steered so now, as a sentence; empty when it is. */
    Optional<String> steer(LeaseHolder.Operation by, DroneId drone, Setpoint setpoint) {
        Optional<String> why = steered(by, drone, setpoint);
        if (why.isEmpty()) {
            steeredDrones.add(drone);
        } else {
            steeredDrones.remove(drone);
        }
        return why;
    }

    private Optional<String> steered(LeaseHolder.Operation by, DroneId drone, Setpoint setpoint) {
        try {
            return cloud.setpoints().steer(source(by), drone, setpoint).map(Refusal::sentence);
        } catch (UnknownDroneException removed) {
            return Optional.of("There is no such drone any more.");
        }
    }

    /** No-op when it is not steered. */
    void stopSteering(LeaseHolder.Operation by, DroneId drone) {
        steeredDrones.remove(drone);
        if (cloud.drone(drone).isPresent()) {
            cloud.setpoints().stopSteering(source(by), drone);
        }
    }

    /** All that are steered now, by whichever operation. */
    Set<DroneId> steeredDrones() {
        return Set.copyOf(steeredDrones);
    }

    private CommandGate.Source source(LeaseHolder.Operation by) {
        return new CommandGate.Source(principal(by), face, null, by);
    }

    Optional<CommandRecord> record(CommandId id) {
        return cloud.gate().find(id);
    }

    private static Principal principal(LeaseHolder.Operation by) {
        return new Principal(by.user(), Role.OPERATOR);
    }
}
