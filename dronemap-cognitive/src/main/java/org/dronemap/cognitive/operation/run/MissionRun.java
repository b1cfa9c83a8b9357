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
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.Scene;

/** Flies a plan with several drones, and changes it when something happens to them. Pure: see {@link Operation}. */
public final class MissionRun implements Operation<RunState, RunInput> {
    private static final Duration RHYTHM = Duration.ofMillis(250);

    @Override
    public Duration rhythm() {
        return RHYTHM;
    }

    @Override
    public Set<DroneId> drones(RunState state) {
        Set<DroneId> drones = new LinkedHashSet<>();
        state.drones().stream()
                .filter(drone -> drone.stage().compareTo(DroneStage.SILENT) <= 0)
                .forEach(drone -> drones.add(drone.id()));
        return state.isOver() ? Set.of() : drones;
    }

    @Override
    public boolean isOver(RunState state) {
        return state.isOver();
    }

    @Override
    public RunInput looked(RunState state, Scene scene) {
        return new RunInput.Looked(scene.now(), List.of());
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
        return Decision.stay(state);
    }

    @Override
    public String words(RunState state) {
        return "The mission run " + state.id();
    }

    @Override
    public Optional<String> refusal(RunState state, RunInput input) {
        return state.isOver() ? Optional.of("The mission run is over.") : Optional.empty();
    }
}
