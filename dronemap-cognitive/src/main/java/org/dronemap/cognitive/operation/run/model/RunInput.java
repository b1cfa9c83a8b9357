package org.dronemap.cognitive.operation.run.model;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** An input of a mission run: an observation, a command's outcome, a new plan, a restart or a user's request. */
public sealed interface RunInput {
    Instant at();

    /** An observation of all remaining drones, in the order of the state's. */
    @Stored(as = "Looked", names = "at drones")
    record Observed(Instant at, List<DroneObservation> drones) implements RunInput {
        public Observed {
            drones = List.copyOf(drones);
        }
    }

    @Stored(as = "CommandEnded", names = "at drone command outcome")
    record CommandEnded(Instant at, DroneId drone, CommandId command, Outcome outcome) implements RunInput {}

    /**
     * The result of a replanning computation, or why it failed.
     *
     * @param result null: it failed
     * @param why it failed, as a sentence
     */
    @Stored(as = "Replanned", names = "at request result why")
    record ReplanEnded(
            Instant at,
            int request,
            org.dronemap.cognitive.replan.@Nullable ReplanResult result,
            @Nullable String why) implements RunInput {}

    /** The process was started again. */
    @Stored(as = "Resumed", names = "at")
    record Restarted(Instant at) implements RunInput {}

    /** A request of a user. */
    sealed interface UserRequest extends RunInput {
        /** The user's name. */
        String by();
    }

    @Stored(as = "AddWaypoints", names = "at by waypoints")
    record AddWaypoints(Instant at, String by, List<Waypoint> waypoints) implements UserRequest {
        public AddWaypoints {
            waypoints = List.copyOf(waypoints);
        }
    }

    @Stored(as = "MoveWaypoint", names = "at by waypoint to")
    record MoveWaypoint(Instant at, String by, String waypoint, Place to) implements UserRequest {}

    @Stored(as = "CancelWaypoint", names = "at by waypoint")
    record CancelWaypoint(Instant at, String by, String waypoint) implements UserRequest {}

    /** A new zone that drones keep to from now on. */
    @Stored(as = "AddBarrier", names = "at by barrier")
    record AddBarrier(Instant at, String by, Barrier barrier) implements UserRequest {}

    /** A further drone, on the ground where {@code craft} says. */
    @Stored(as = "JoinDrone", names = "at by craft name kind")
    record JoinDrone(Instant at, String by, Craft craft, String name, VehicleKind kind) implements UserRequest {}

    /** A further drone that the cloud chose of the pool in the place of one that is lost; {@code why} as sentences. */
    @Stored(as = "JoinFromPool", names = "at by craft name kind why")
    record JoinFromPool(Instant at, String by, Craft craft, String name, VehicleKind kind, String why)
            implements UserRequest {}

    /** No drone of the pool can join now; {@code why} as one or more sentences. */
    @Stored(as = "NoPoolDrone", names = "at by why")
    record NoPoolDrone(Instant at, String by, String why) implements UserRequest {}

    /** The only way back for a drone that somebody took. */
    @Stored(as = "ResumeDrone", names = "at by drone")
    record ResumeDrone(Instant at, String by, DroneId drone) implements UserRequest {}

    /** It is called home, and others do the rest. */
    @Stored(as = "GiveUpDrone", names = "at by drone")
    record GiveUpDrone(Instant at, String by, DroneId drone) implements UserRequest {}

    @Stored(as = "Answer", names = "at by proposal accepted")
    record AnswerProposal(Instant at, String by, int proposal, boolean accepted) implements UserRequest {}

    /** Pauses the run: all drones wait where they are. */
    @Stored(as = "Pause", names = "at by")
    record Pause(Instant at, String by) implements UserRequest {}

    /** Resumes a paused run. */
    @Stored(as = "GoOn", names = "at by")
    record Resume(Instant at, String by) implements UserRequest {}

    /** Stops the run: all drones return home. */
    @Stored(as = "Stop", names = "at by")
    record Stop(Instant at, String by) implements UserRequest {}
}
