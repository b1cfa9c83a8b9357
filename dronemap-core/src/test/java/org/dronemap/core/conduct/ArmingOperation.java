package org.dronemap.core.conduct;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.Computation;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationCodec;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.time.Time;

/** A tiny operation: arms its drones, notes what it hears, lets go of drones that somebody takes. */
final class ArmingOperation implements Operation<ArmingOperation.State, String> {
    /** What it heard, in order; {@code given}: how many commands. */
    record State(Set<String> drones, List<String> heard, int given, boolean over) {
        State heard(String what) {
            List<String> all = new ArrayList<>(heard);
            all.add(what);
            return new State(drones, List.copyOf(all), given, over);
        }
    }

    /** Ends with its word; that of which it is told to wait waits until it may. */
    record TestComputation(String word) implements Computation<String> {
        static volatile CountDownLatch mayEnd = new CountDownLatch(0);

        @Override
        public String run(Time time, BooleanSupplier cancelled) {
            try {
                if (!mayEnd.await(10, TimeUnit.SECONDS)) {
                    return "note slow";
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return "note " + word;
        }

        @Override
        public String failed(String why, InstantSource clock) {
            return "note failed: " + why;
        }
    }

    static final OperationKind<State, String> KIND = new OperationKind<>("watch", new ArmingOperation(1), new Codec());

    /** It fails at the end of any command. */
    static volatile boolean poisonous;

    private final int step;

    /** {@code step}: by how much commands are counted. */
    ArmingOperation(int step) {
        this.step = step;
    }

    static State of(DroneId... drones) {
        Set<String> ids = new LinkedHashSet<>();
        for (DroneId drone : drones) {
            ids.add(drone.value());
        }
        return new State(ids, List.of(), 0, false);
    }

    @Override
    public Duration rhythm() {
        return Duration.ofMillis(50);
    }

    @Override
    public Set<DroneId> drones(State state) {
        Set<DroneId> drones = new LinkedHashSet<>();
        state.drones().forEach(drone -> drones.add(new DroneId(drone)));
        return drones;
    }

    @Override
    public boolean isOver(State state) {
        return state.over();
    }

    @Override
    public String observed(State state, OperationObservation scene) {
        return scene.drones().stream()
                .filter(seen -> seen.whyNotCommandable() != null)
                .map(seen -> "taken " + seen.state().id() + " " + seen.whyNotCommandable())
                .findFirst()
                .orElse("looked");
    }

    @Override
    public String ended(DroneId drone, CommandId command, Outcome outcome, Instant at) {
        return "note ended " + command + " " + outcome.getClass().getSimpleName();
    }

    @Override
    public String resumed(Instant at) {
        return "note resumed";
    }

    @Override
    public OperationDecision<State, String> decide(State state, String input) {
        if (poisonous && input.startsWith("note ended")) {
            throw new IllegalStateException("a fault of its own");
        }
        String[] words = input.split(" ", 3);
        return switch (words[0]) {
            case "note" ->
                new OperationDecision<>(state.heard(input.substring(5)), List.of(), "It heard " + input.substring(5));
            case "arm" -> give(state, new Command.Arm());
            case "home" -> give(state, new Command.ReturnToLaunch());
            case "compute" ->
                new OperationDecision<>(
                        state.heard("asked"),
                        List.of(new OperationAction.Compute<>(new TestComputation(words[1]))),
                        null);
            case "taken" -> taken(state, words[1], words[2]);
            case "stop" ->
                new OperationDecision<>(
                        new State(state.drones(), state.heard(), state.given(), true), List.of(), "It was stopped.");
            default -> OperationDecision.unchanged(state);
        };
    }

    private OperationDecision<State, String> give(State state, Command command) {
        List<OperationAction<String>> actions = new ArrayList<>();
        int given = state.given();
        for (String drone : state.drones()) {
            given += step;
            actions.add(
                    new OperationAction.SendCommand<>(new DroneId(drone), new CommandId("command-" + given), command));
        }
        return new OperationDecision<>(new State(state.drones(), state.heard(), given, false), actions, null);
    }

    private static OperationDecision<State, String> taken(State state, String drone, String by) {
        Set<String> rest = new LinkedHashSet<>(state.drones());
        rest.remove(drone);
        return new OperationDecision<>(
                new State(rest, state.heard("taken " + by).heard(), state.given(), false), List.of(), null);
    }

    @Override
    public String words(State state) {
        return "A watch";
    }

    @Override
    public Optional<Objection> refusal(State state, String input) {
        return input.equals("no")
                ? Optional.of(Objection.of(OperationObjection.NOT_CONDUCTED, "Not that."))
                : Optional.empty();
    }

    /** One line each. */
    private static final class Codec implements OperationCodec<State, String> {
        @Override
        public String state(State state) {
            return String.join(",", state.drones()) + "|" + String.join(";", state.heard()) + "|" + state.given() + "|"
                    + state.over();
        }

        @Override
        public State state(String text) {
            String[] parts = text.split("\\|", -1);
            if (parts.length != 4) {
                throw new IllegalArgumentException("no state of a watch: " + text);
            }
            Set<String> drones = parts[0].isEmpty() ? Set.of() : new LinkedHashSet<>(List.of(parts[0].split(",")));
            List<String> heard = parts[1].isEmpty() ? List.of() : List.of(parts[1].split(";"));
            return new State(drones, heard, Integer.parseInt(parts[2]), Boolean.parseBoolean(parts[3]));
        }

        @Override
        public String input(String input) {
            return input;
        }

        @Override
        public String decision(OperationDecision<State, String> decision) {
            return decision.actions().size() + " actions, to " + state(decision.next());
        }
    }
}
