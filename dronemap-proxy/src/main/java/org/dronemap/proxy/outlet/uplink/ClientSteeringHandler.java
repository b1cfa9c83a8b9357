package org.dronemap.proxy.outlet.uplink;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.jspecify.annotations.Nullable;

/**
 * Handles stick input and setpoints of ground stations at the outlet: steers as their users, or explains why not. Owned
 * by the outlet's thread.
 */
final class ClientSteeringHandler {
    private static final long BETWEEN_SENTENCES_NANOS = 10_000_000_000L;

    private final CloudManager cloud;
    private final ClientCommandExecutor orders;
    private final Map<ClientDrone, SteeringState> hands = new HashMap<>();

    /** A client at a drone. */
    private record ClientDrone(String client, DroneId drone) {}

    /** In whose name it says what places there, and whether it is at the helm. */
    private record SteeringState(Principal principal, PositionTargetClassifier places, boolean leads) {}

    ClientSteeringHandler(CloudManager cloud, ClientCommandExecutor orders) {
        this.cloud = cloud;
        this.orders = orders;
    }

    void handle(ClientRequest asked, long now) {
        Principal principal = asked.client().principal();
        DroneState state = cloud.drone(asked.drone()).orElse(null);
        if (principal == null || state == null) {
            return;
        }
        if (asked.client().onlyLooks()) {
            explain(asked, "This is a port to look only; to steer, sign.", now);
            return;
        }
        int component = ClientSteeringReader.component(asked.frame());
        if (component != 0 && component != asked.vehicle().component()) {
            explain(asked, "This is for component " + component + "; only the autopilot is steered.", now);
            return;
        }
        ClientDrone seat = new ClientDrone(asked.client().id(), asked.drone());
        ClientSteeringReader.Intent wish =
                ClientSteeringReader.of(asked.frame(), state.identification().kind());
        if (wish instanceof ClientSteeringReader.Intent.Denied denied) {
            explain(asked, denied.sentence(), now);
        } else if (wish instanceof ClientSteeringReader.Intent.LetGo) {
            release(seat, hands.remove(seat));
        } else if (wish instanceof ClientSteeringReader.Intent.Steer steer) {
            hands.put(seat, new SteeringState(principal, places(seat), true));
            steer.remark().ifPresent(sentence -> explain(asked, sentence, now));
            steer(asked, principal, steer.setpoint(), now);
        } else if (wish instanceof ClientSteeringReader.Intent.Place place) {
            place(asked, principal, place.track(), now);
        }
    }

    private void place(ClientRequest asked, Principal principal, Setpoint.Track track, long now) {
        ClientDrone seat = new ClientDrone(asked.client().id(), asked.drone());
        PositionTargetClassifier places = places(seat);
        switch (places.classify(track, now)) {
            case GO_TO -> {
                hands.put(seat, new SteeringState(principal, places, false));
                goTo(asked, principal, track);
            }
            case SAID_AGAIN -> {}
            case LEADS -> {
                hands.put(seat, new SteeringState(principal, places, true));
                steer(asked, principal, track, now);
            }
        }
    }

    private PositionTargetClassifier places(ClientDrone seat) {
        SteeringState before = hands.get(seat);
        return before == null ? new PositionTargetClassifier() : before.places();
    }

    private void goTo(ClientRequest asked, Principal principal, Setpoint.Track track) {
        if (asked.client().mayOrder()) {
            Command command = new Command.GoTo(track.point(), track.altitude());
            orders.submit(principal, asked.drone(), command, new GoToReporter(asked));
        }
    }

    private void steer(ClientRequest asked, Principal principal, Setpoint setpoint, long now) {
        if (!asked.client().maySteer()) {
            return;
        }
        try {
            Optional<Refusal> why = cloud.setpoints().steer(source(principal), asked.drone(), setpoint);
            // Programs with a joystick say its middle all the time, whatever the drone does.
            why.filter(refusal -> !setpoint.isStill()).ifPresent(refusal -> explain(asked, refusal.sentence(), now));
        } catch (UnknownDroneException removedMeanwhile) {
            explain(asked, "This drone was removed.", now);
        }
    }

    /** The client has gone: what it steered stands still. */
    void forget(String client) {
        for (ClientDrone seat : Set.copyOf(hands.keySet())) {
            if (seat.client().equals(client)) {
                release(seat, hands.remove(seat));
            }
        }
    }

    private void release(ClientDrone seat, @Nullable SteeringState hand) {
        if (hand != null && hand.leads() && cloud.drone(seat.drone()).isPresent()) {
            cloud.setpoints().stopSteering(source(hand.principal()), seat.drone());
        }
    }

    private static CommandGate.Source source(Principal principal) {
        return new CommandGate.Source(principal, ClientCommandExecutor.FACE);
    }

    private static void explain(ClientRequest asked, String why, long now) {
        if (asked.client().mayExplain(why, now, BETWEEN_SENTENCES_NANOS)) {
            asked.explain(why);
        }
    }

    /** A target is not acknowledged; what comes of it is told where it is not done. */
    private record GoToReporter(ClientRequest asked) implements ClientCommandExecutor.Callback {
        @Override
        public void accepted() {
            // There is no message for it.
        }

        @Override
        public void ended(Outcome outcome) {
            String why = OutcomeTranslator.sentence(outcome);
            if (!why.isEmpty()) {
                asked.explain(why);
            }
        }
    }
}
