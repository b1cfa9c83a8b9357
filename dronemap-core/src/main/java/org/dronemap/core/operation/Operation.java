package org.dronemap.core.operation;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.separation.FlightIntent;

/**
 * A long-running task that the cloud carries out with drones (a mission run, a follow), as a pure state machine. Who
 * conducts it takes control of its drones, writes each decision down before anything of it happens, carries it out, and
 * goes on after a restart.
 *
 * @param <S> what it remembers; immutable, written down
 * @param <I> what befalls it, reduced to what matters to it; immutable, written down
 */
public interface Operation<S, I> {
    /** So often it looks at its drones. */
    Duration rhythm();

    /**
     * The drones whose control it needs now, in an order that hangs on the state alone: they are asked for and given back
     * in it. What is no longer among them is given back.
     */
    Set<DroneId> drones(S state);

    /** The drones that it looks at, such as those it was parted from: a scene shows these and those that it controls. */
    default Set<DroneId> watched(S state) {
        return drones(state);
    }

    /**
     * What it means its drones to do next, for those who keep all drones apart; drones that it means nothing of are left out.
     * It hangs on the state and the moment alone.
     */
    default Map<DroneId, FlightIntent> intents(S state, Instant now) {
        return Map.of();
    }

    /** Who steers its drones between its decisions; empty: nobody does. Asked once, when it is taken up. */
    default Optional<OperationGuidance<S>> guidance(S state) {
        return Optional.empty();
    }

    /** Nothing will happen any more. */
    boolean isOver(S state);

    /** What matters of what is seen now. */
    I observed(S state, OperationObservation scene);

    /** A command that it gave has ended. */
    I ended(DroneId drone, CommandId command, Outcome outcome, Instant at);

    /** The process was started again; what it had asked to be computed is lost. */
    I resumed(Instant at);

    /** What follows. An input that changes nothing and asks for nothing is not written down. */
    OperationDecision<S, I> decide(S state, I input);

    /** A drone's holder as people read it: the beginning of a sentence. */
    String words(S state);

    /** Why this input cannot be taken now; asked for what users want, before it is decided on. */
    Optional<Objection> refusal(S state, I input);
}
