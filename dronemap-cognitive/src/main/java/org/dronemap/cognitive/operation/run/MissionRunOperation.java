package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.separation.FlightIntent;

/** The state machine of a mission run: several drones fly a plan, which changes when something happens to them. */
public final class MissionRunOperation implements Operation<RunState, RunInput> {
    private static final Duration RHYTHM = Duration.ofMillis(250);
    /** After a restart, until drones that are there have been heard. */
    private static final Duration GRACE = Duration.ofSeconds(20);

    @Override
    public Duration rhythm() {
        return RHYTHM;
    }

    @Override
    public Set<DroneId> drones(RunState state) {
        Set<DroneId> drones = new LinkedHashSet<>();
        state.drones().stream()
                .filter(drone -> !state.isOver()
                        && drone.stage().compareTo(RunDroneStage.SILENT) <= 0
                        && !isDismissed(state, drone))
                .forEach(drone -> drones.add(drone.id()));
        return drones;
    }

    /** It is down, nothing of the run's is left in it, and the run gives it nothing more to do. */
    private static boolean isDismissed(RunState state, RunDrone drone) {
        return state.stopping()
                && drone.stage() == RunDroneStage.LANDED
                && drone.flags().returnHeight() == null
                && drone.issuedCommand() == null;
    }

    @Override
    public Set<DroneId> watched(RunState state) {
        Set<DroneId> drones = new LinkedHashSet<>();
        state.drones().forEach(drone -> drones.add(drone.id()));
        return drones;
    }

    @Override
    public Map<DroneId, FlightIntent> intents(RunState state, Instant now) {
        return RunIntents.of(state, now);
    }

    @Override
    public boolean isOver(RunState state) {
        return state.isOver();
    }

    @Override
    public RunInput observed(RunState state, OperationObservation scene) {
        return RunObservations.of(state, scene);
    }

    @Override
    public RunInput ended(DroneId drone, CommandId command, Outcome outcome, Instant at) {
        return new RunInput.CommandEnded(at, drone, command, outcome);
    }

    @Override
    public RunInput resumed(Instant at) {
        return new RunInput.Restarted(at);
    }

    @Override
    public OperationDecision<RunState, RunInput> decide(RunState state, RunInput input) {
        if (state.isOver()) {
            return OperationDecision.unchanged(state);
        }
        RunTransition draft = new RunTransition(state, input.at());
        if (input instanceof RunInput.Observed looked) {
            looked(draft, looked.drones());
        } else if (input instanceof RunInput.CommandEnded ended) {
            RunCommandResults.ended(draft, ended);
        } else if (input instanceof RunInput.ReplanEnded replanned) {
            ReplanAdoption.planComputed(draft, replanned);
        } else if (input instanceof RunInput.Restarted) {
            RunDroneMonitor.restarted(draft, GRACE);
        } else if (input instanceof RunInput.UserRequest wish
                && refusal(state, wish).isEmpty()) {
            RunUserRequests.apply(draft, wish);
        }
        return draft.decision();
    }

    /** In this order: what was reached, what befell, what is asked for, what each does next. */
    private static void looked(RunTransition draft, List<DroneObservation> looks) {
        looks.forEach(look -> VisitTracking.update(draft, look));
        for (RunDrone drone : draft.drones()) {
            if (looks.stream().noneMatch(look -> look.drone().equals(drone.id()))) {
                RunDroneMonitor.removed(draft, drone);
            }
        }
        looks.forEach(look -> RunDroneMonitor.observe(draft, look));
        ReplanScheduler.requestIfNeeded(draft, looks);
        LaunchTiming.launchWhenReady(draft);
        looks.forEach(look -> RunYielding.update(draft, look));
        looks.forEach(look -> RunCommands.advance(draft, look));
        RunCompletion.close(draft);
    }

    @Override
    public String words(RunState state) {
        return "The mission run " + state.id();
    }

    @Override
    public Optional<Objection> refusal(RunState state, RunInput input) {
        return RunRefusals.of(state, input);
    }
}
