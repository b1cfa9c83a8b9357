package org.dronemap.proxy.outlet.uplink;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseRequest;
import org.dronemap.core.lease.LeaseStep;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.proxy.outlet.client.OutletClient;
import org.jspecify.annotations.Nullable;

/**
 * Handles requests of ground stations at the outlet to take or release control (MAV_CMD_REQUEST_OPERATOR_CONTROL). A
 * client that took control keeps it for its user for as long as its heartbeats come. Owned by the outlet's thread.
 */
final class ClientControlHandler {
    private static final String REASON = "through a ground station";

    private final CloudManager cloud;
    private final ClientCommandExecutor orders;
    /** By client: which drones it took. */
    private final Map<String, Set<DroneId>> kept = new HashMap<>();

    ClientControlHandler(CloudManager cloud, ClientCommandExecutor orders) {
        this.cloud = cloud;
        this.orders = orders;
    }

    /** Takes, asks for or gives back control; nothing else is wished for here. */
    void handle(ClientRequest asked, ClientIntent wish) {
        if (wish instanceof ClientIntent.Control control) {
            request(asked, control);
        } else {
            release(asked);
        }
    }

    /** Takes or asks for control. */
    private void request(ClientRequest asked, ClientIntent.Control wish) {
        Principal principal = asked.client().principal();
        if (principal == null) {
            return;
        }
        if (!principal.may(Role.OPERATOR, asked.drone())) {
            refuse(asked, "Your role may not have control of it.");
            return;
        }
        ControlState control = cloud.controls().control(asked.drone());
        LeaseEvent event = event(asked, principal.name(), control, wish);
        if (event == null) {
            acknowledge(asked, OutcomeTranslator.ACCEPTED);
            if (wish.allowTakeover()) {
                asked.explain("Control passes only to somebody who asks for it; nobody does now.");
            }
        } else {
            act(asked, principal, event);
        }
    }

    /** Null when all is as wanted. */
    private @Nullable LeaseEvent event(
            ClientRequest asked, String user, ControlState control, ClientIntent.Control wish) {
        if (!control.isHeldBy(user)) {
            return new LeaseEvent.Request(user, REASON);
        }
        if (wish.allowTakeover() && !control.requests().isEmpty()) {
            LeaseRequest oldest = control.requests().get(0);
            return new LeaseEvent.Grant(user, oldest.by());
        }
        return keeps(asked.client(), asked.drone()) ? null : new LeaseEvent.TakeControl(user);
    }

    /** Gives control back. */
    private void release(ClientRequest asked) {
        Principal principal = asked.client().principal();
        if (principal == null) {
            return;
        }
        boolean may = principal.may(Role.OPERATOR, asked.drone()) || principal.may(Role.PLANNER, asked.drone());
        if (may) {
            act(asked, principal, new LeaseEvent.Release(principal.name()));
        } else {
            refuse(asked, "Your role may not have control of it.");
        }
    }

    private void act(ClientRequest asked, Principal principal, LeaseEvent event) {
        if (asked.client().mayOrder()) {
            orders.act(principal, asked.drone(), event, step -> answer(asked, event, step));
        } else {
            acknowledge(asked, OutcomeTranslator.TEMPORARILY_REJECTED);
        }
    }

    /** {@code step} null: it could not be decided. */
    private void answer(ClientRequest asked, LeaseEvent event, @Nullable LeaseStep step) {
        if (step == null) {
            acknowledge(asked, OutcomeTranslator.TEMPORARILY_REJECTED);
            asked.explain("The server could not take that down; nothing was changed.");
        } else if (step.answer() instanceof LeaseAnswer.Denied denied) {
            refuse(asked, denied.why());
        } else if (step.answer() instanceof LeaseAnswer.Waiting) {
            acknowledge(asked, OutcomeTranslator.FAILED);
            asked.explain("Its holder was asked for control. " + step.control().sentence());
        } else {
            keep(asked, event instanceof LeaseEvent.TakeControl || event instanceof LeaseEvent.Request);
            acknowledge(asked, OutcomeTranslator.ACCEPTED);
        }
    }

    private void keep(ClientRequest asked, boolean from) {
        Set<DroneId> drones = kept.computeIfAbsent(asked.client().id(), client -> new HashSet<>());
        if (from) {
            drones.add(asked.drone());
        } else {
            drones.remove(asked.drone());
        }
    }

    private boolean keeps(OutletClient client, DroneId drone) {
        return kept.getOrDefault(client.id(), Set.of()).contains(drone);
    }

    /** The client's heartbeat is the sign of life of whoever has control by it. */
    void alive(OutletClient client) {
        Set<DroneId> drones = kept.get(client.id());
        Principal principal = client.principal();
        if (drones != null && principal != null) {
            drones.removeIf(drone -> !isHeld(drone, principal.name()));
        }
    }

    private boolean isHeld(DroneId drone, String user) {
        ControlState control = cloud.controls().control(drone);
        if (!control.isHeldBy(user)) {
            return false;
        }
        try {
            LeaseEvent sign = new LeaseEvent.Heartbeat(user, control.epoch());
            return !(cloud.controls().apply(drone, sign).answer() instanceof LeaseAnswer.Denied);
        } catch (UnknownDroneException removed) {
            return false;
        }
    }

    /** The client has gone: nothing keeps what it took any more. */
    void forget(String client) {
        kept.remove(client);
    }

    private static void refuse(ClientRequest asked, String why) {
        acknowledge(asked, OutcomeTranslator.DENIED);
        asked.explain(why);
    }

    private static void acknowledge(ClientRequest asked, int result) {
        asked.answer(new CommandAck(
                ClientCommandReader.OPERATOR_CONTROL, result, 0, 0, asked.fromSystem(), asked.fromComponent()));
    }
}
