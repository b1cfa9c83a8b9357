package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.Decision;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.Scene;

/**
 * Flies a plan with several drones, and changes it when something happens to them: a function of what it remembers and of
 * what befalls it.
 */
public final class MissionRun implements Operation<RunState, RunInput> {
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
                .filter(drone -> !state.isOver() && drone.stage().compareTo(DroneStage.SILENT) <= 0)
                .forEach(drone -> drones.add(drone.id()));
        return drones;
    }

    @Override
    public Set<DroneId> watched(RunState state) {
        Set<DroneId> drones = new LinkedHashSet<>();
        state.drones().forEach(drone -> drones.add(drone.id()));
        return drones;
    }

    @Override
    public boolean isOver(RunState state) {
        return state.isOver();
    }

    @Override
    public RunInput looked(RunState state, Scene scene) {
        return Sights.of(state, scene);
    }

    @Override
    public RunInput ended(DroneId drone, CommandId command, Outcome outcome, Instant at) {
        return new RunInput.CommandEnded(at, drone, command, outcome);
    }

    @Override
    public RunInput resumed(Instant at) {
        return new RunInput.Resumed(at);
    }

    @Override
    public Decision<RunState, RunInput> decide(RunState state, RunInput input) {
        if (state.isOver()) {
            return Decision.stay(state);
        }
        Draft draft = new Draft(state, input.at());
        if (input instanceof RunInput.Looked looked) {
            looked(draft, looked.drones());
        } else if (input instanceof RunInput.CommandEnded ended) {
            Errands.ended(draft, ended);
        } else if (input instanceof RunInput.Replanned replanned) {
            Applying.arrived(draft, replanned);
        } else if (input instanceof RunInput.Resumed) {
            Watch.restarted(draft, GRACE);
        } else if (input instanceof RunInput.Wish wish && refusal(state, wish).isEmpty()) {
            Wishes.wish(draft, wish);
        }
        return draft.decision();
    }

    /** In this order: what was reached, what befell, what is asked for, what each does next. */
    private static void looked(Draft draft, List<Look> looks) {
        looks.forEach(look -> Reckoning.reckon(draft, look));
        for (RunDrone drone : draft.drones()) {
            if (looks.stream().noneMatch(look -> look.drone().equals(drone.id()))) {
                Watch.removed(draft, drone);
            }
        }
        looks.forEach(look -> Watch.look(draft, look));
        Planning.ask(draft, looks);
        Launch.prepare(draft);
        Guard.watch(draft, looks);
        looks.forEach(look -> Steps.go(draft, look));
        Closing.close(draft);
    }

    @Override
    public String words(RunState state) {
        return "The mission run " + state.id();
    }

    @Override
    public Optional<Objection> refusal(RunState state, RunInput input) {
        return Refusals.of(state, input);
    }
}
