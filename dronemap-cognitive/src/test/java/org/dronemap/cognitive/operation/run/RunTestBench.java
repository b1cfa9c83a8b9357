package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Predicate;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.time.SteppedTime;

/** Conducts a run with vehicles of the tests in virtual time, as fast as it can be computed, and watches what must hold. */
final class RunTestBench {
    static final Instant START = Instant.parse("2030-05-01T10:00:00Z");
    private static final Duration STEP = Duration.ofMillis(250);
    private static final double PART = 0.05;
    private static final double AT_METERS = 1.5;

    final MissionRunOperation run = new MissionRunOperation();
    final Map<DroneId, TestVehicle> vehicles = new LinkedHashMap<>();
    final List<RunInput> journal = new ArrayList<>();
    final List<OperationDecision<RunState, RunInput>> decisions = new ArrayList<>();
    final Map<String, List<DroneId>> visits = new LinkedHashMap<>();
    final List<String> said = new ArrayList<>();
    final RunState first;
    RunState state;
    Instant now = START;
    /** Refuses or loses commands. */
    Predicate<OperationAction.SendCommand<RunInput>> loses = give -> false;
    /** What the vehicle, or the gate, answers instead of doing it. */
    Function<OperationAction.SendCommand<RunInput>, Optional<Outcome>> refuses = give -> Optional.empty();

    private final TestAirspace airspace = new TestAirspace();
    double closest = Double.POSITIVE_INFINITY;
    String where = "";
    private final Map<DroneId, DroneState> heard = new HashMap<>();
    private final Map<DroneId, Integer> counted = new HashMap<>();
    private final List<Due> due = new ArrayList<>();
    private boolean serverDown;

    /** Something that happens later. */
    private record Due(Instant at, Runnable what, boolean ofServer) {}

    RunTestBench(RunOrder order, List<TestVehicle> fleet) {
        fleet.forEach(vehicle -> vehicles.put(vehicle.id, vehicle));
        state = RunState.begin(order);
        first = state;
    }

    TestVehicle vehicle(int number) {
        return vehicles.get(new DroneId("d" + number));
    }

    RunDrone drone(int number) {
        return state.drone(new DroneId("d" + number)).orElseThrow();
    }

    void fly(double seconds) {
        Instant end = now.plusMillis(Math.round(seconds * 1000));
        while (now.isBefore(end)) {
            step();
        }
    }

    void flyUntil(BooleanSupplier reached, double longestSeconds) {
        Instant end = now.plusMillis(Math.round(longestSeconds * 1000));
        while (!reached.getAsBoolean()) {
            assertThat(now)
                    .as("until it is so; said: %s; %s", said, state.drones())
                    .isBefore(end);
            step();
        }
    }

    void flyToTheEnd() {
        flyUntil(() -> state.isOver(), 3_600);
        assertThat(state.targets()).allMatch(target -> target.state().isSettled());
        trueVisits();
        replays();
    }

    private void step() {
        now = now.plus(STEP);
        vehicles.values().forEach(vehicle -> {
            for (double t = 0; t < STEP.toMillis() / 1_000.0 - PART / 2; t += PART) {
                vehicle.step(PART);
            }
        });
        reckon();
        apart();
        List<Due> then = due.stream().filter(each -> !each.at().isAfter(now)).toList();
        due.removeAll(then);
        then.stream()
                .filter(each -> !(serverDown && each.ofServer()))
                .forEach(each -> each.what().run());
        if (!serverDown && !state.isOver()) {
            keepApart();
            input(run.observed(state, scene()));
        }
        oneAssignment();
    }

    void input(RunInput input) {
        OperationDecision<RunState, RunInput> decision = run.decide(state, input);
        boolean nothing = decision.next().equals(state) && decision.actions().isEmpty();
        if (nothing) {
            return;
        }
        journal.add(input);
        decisions.add(decision);
        state = decision.next();
        if (decision.why() != null) {
            said.add(Duration.between(START, now).toMillis() / 1000.0 + " " + decision.why());
        }
        decision.actions().forEach(this::act);
    }

    /** It stands in that mode and has been told to make room for the other one, which takes it so long; nothing of it is in the journal. */
    TestVehicle makesRoom(int number, int other, String mode, long seconds) {
        TestVehicle vehicle = vehicle(number);
        vehicle.mode = mode;
        airspace.makesRoom(vehicle.id, vehicle(other).id, now, seconds);
        fly(STEP.toMillis() / 1_000.0);
        return vehicle;
    }

    void wish(RunInput wish) {
        assertThat(run.refusal(state, wish)).isEmpty();
        input(wish);
    }

    private void act(OperationAction<RunInput> action) {
        if (action instanceof OperationAction.SendCommand<RunInput> give) {
            give(give);
        } else if (action instanceof OperationAction.Compute<RunInput> compute) {
            ReplanComputation replan = (ReplanComputation) compute.what();
            Instant at = now.plus(replan.limit()).plusMillis(100);
            later(at, true, () -> {
                input(replan.run(new SteppedTime(now), () -> false));
            });
        }
    }

    private void later(Instant at, boolean ofServer, Runnable what) {
        due.add(new Due(at, what, ofServer));
    }

    private void give(OperationAction.SendCommand<RunInput> give) {
        boolean lost = loses.test(give);
        boolean long_ = give.command() instanceof Command.UploadMission;
        Optional<Outcome> refusal = refuses.apply(give);
        later(now.plusMillis(long_ ? 900 : 300), false, () -> {
            TestVehicle vehicle = vehicles.get(give.drone());
            if (long_ && vehicle.transfer != null) {
                ended(
                        give.drone(),
                        give.id(),
                        new Outcome.Refused("gate", "Wait for its end.", OutcomeCode.COMMAND_REFUSED),
                        Duration.ZERO);
            } else if (vehicle.cut || lost) {
                ended(give.drone(), give.id(), new Outcome.TimedOut("No answer."), Duration.ofSeconds(5));
            } else if (refusal.isPresent()) {
                ended(give.drone(), give.id(), refusal.get(), Duration.ZERO);
            } else {
                String fault = vehicle.carryOut(give.command());
                ended(
                        give.drone(),
                        give.id(),
                        fault == null
                                ? new Outcome.Succeeded()
                                : new Outcome.Refused("vehicle", fault, OutcomeCode.VEHICLE_REFUSED),
                        Duration.ZERO);
            }
        });
    }

    private void ended(DroneId drone, CommandId id, Outcome outcome, Duration after) {
        later(now.plus(after), true, () -> input(run.ended(drone, id, outcome, now)));
    }

    OperationObservation scene() {
        List<OperationObservation.ObservedDrone> seen = new ArrayList<>();
        vehicles.values().forEach(vehicle -> seen.add(seen(vehicle)));
        return new OperationObservation(now, seen);
    }

    private OperationObservation.ObservedDrone seen(TestVehicle vehicle) {
        if (!vehicle.cut) {
            heard.put(vehicle.id, vehicle.state(now));
        }
        DroneState last = heard.get(vehicle.id);
        Duration silence = Duration.between(last.lastUpdate(), now);
        LinkState link = silence.toMillis() > 5_000
                ? LinkState.LOST
                : silence.toMillis() > 1_500 ? LinkState.SUSPECT : LinkState.LIVE;
        Duration still = Duration.ofMillis(Math.round(1_000 * vehicle.stillFor));
        return new OperationObservation.ObservedDrone(
                linked(last, link),
                new OperationObservation.ControlStatus(
                        run.drones(state).contains(vehicle.id) ? vehicle.takenBy : "nobody",
                        null,
                        false,
                        vehicle.transfer),
                link == LinkState.LIVE ? Duration.ZERO : silence,
                link == LinkState.LIVE ? still : Duration.ZERO,
                airspace.giveWay(vehicle.id));
    }

    /** As the conductor of separation does, with what the run means its drones to do. */
    private void keepApart() {
        airspace.look(
                        now,
                        run.intents(state, now),
                        scene(),
                        state.setting().rules().separation())
                .forEach(order -> {
                    later(now.plusMillis(300), false, () -> {
                        TestVehicle vehicle = Objects.requireNonNull(vehicles.get(order.to()));
                        if (!vehicle.cut) {
                            vehicle.carryOut(order.command());
                        }
                    });
                });
    }

    private static DroneState linked(DroneState s, LinkState link) {
        LinkStatus old = s.link();
        return new DroneState(
                s.id(),
                s.name(),
                s.replay(),
                new LinkStatus(old.key(), old.transport(), link, old.lastHeard(), old.quality(), old.others()),
                s.identification(),
                s.standing(),
                s.capabilities(),
                s.mode(),
                s.armed(),
                s.readyToArm(),
                s.phase(),
                s.position(),
                null,
                s.motion(),
                s.attitude(),
                s.battery(),
                s.gps(),
                s.home(),
                s.returnHeight(),
                s.payload(),
                s.mission(),
                s.messages(),
                s.lastUpdate(),
                s.version(),
                null);
    }

    /** The process dies, and is there again after that time. */
    void restart(double seconds) {
        serverDown = true;
        due.removeIf(Due::ofServer);
        vehicles.values().forEach(vehicle -> vehicle.alone = true);
        fly(seconds);
        serverDown = false;
        vehicles.values().forEach(vehicle -> vehicle.alone = false);
        vehicles.values().forEach(TestVehicle::forgotten);
        input(run.resumed(now));
    }

    /** Who truly came where, by what it flew. */
    private void reckon() {
        vehicles.values().forEach(vehicle -> {
            int from = counted.getOrDefault(vehicle.id, 0);
            for (MissionItem.Waypoint place : vehicle.visits.subList(from, vehicle.visits.size())) {
                meant(place)
                        .ifPresent(target -> visits.computeIfAbsent(target.id(), id -> new ArrayList<>())
                                .add(vehicle.id));
            }
            counted.put(vehicle.id, vehicle.visits.size());
        });
    }

    /** The nearest: two waypoints may be less than a stride apart. */
    private Optional<RunWaypoint> meant(MissionItem.Waypoint place) {
        return state.targets().stream()
                .filter(target -> isAt(target, place))
                .min(Comparator.comparingDouble(target -> meters(target, place)));
    }

    private static double meters(RunWaypoint target, MissionItem.Waypoint place) {
        return Geodesy.distanceMeters(target.waypoint().place().point(), place.point());
    }

    private static boolean isAt(RunWaypoint target, MissionItem.Waypoint place) {
        return meters(target, place) < AT_METERS
                && Math.abs(target.waypoint().place().altitudeAmslMeters()
                                - place.altitude().meters())
                        < 6;
    }

    private void apart() {
        List<TestVehicle> up =
                vehicles.values().stream().filter(TestVehicle::isUp).toList();
        for (int i = 0; i < up.size(); i++) {
            for (int j = i + 1; j < up.size(); j++) {
                TestVehicle one = up.get(i);
                TestVehicle other = up.get(j);
                double vertical = Math.abs(one.altitude - other.altitude);
                double meters = Math.hypot(one.east - other.east, one.north - other.north);
                boolean wreck = one.falling || other.falling;
                if (vertical < 4.5 && !wreck && meters < closest) {
                    closest = meters;
                    where = one.id + " in " + one.mode + " and " + other.id + " in " + other.mode + " after "
                            + Duration.between(START, now).toSeconds() + " s";
                }
            }
        }
    }

    /** Nobody in contact flies to what another one in contact flies to as well. */
    private void oneAssignment() {
        Map<String, DroneId> heads = new HashMap<>();
        for (TestVehicle vehicle : vehicles.values()) {
            RunDrone drone = state.drone(vehicle.id).orElse(null);
            boolean counts = drone != null
                    && vehicle.fliesMission()
                    && vehicle.heardFor > 10
                    && drone.stage().acceptsCommands();
            if (!counts) {
                continue;
            }
            for (int item = vehicle.current; item < vehicle.items.size(); item++) {
                if (vehicle.items.get(item) instanceof MissionItem.Waypoint place) {
                    meant(place).filter(target -> !target.state().isSettled()).ifPresent(target -> {
                        DroneId other = heads.put(target.id(), vehicle.id);
                        assertThat(other == null || other.equals(vehicle.id))
                                .as("%s is on its way to %s and %s; %s", target.id(), other, vehicle.id, said)
                                .isTrue();
                    });
                }
            }
        }
    }

    /** What the run says was visited was visited, and what was visited more than once is counted. */
    private void trueVisits() {
        int doubles = 0;
        for (RunWaypoint target : state.targets()) {
            List<DroneId> by = visits.getOrDefault(target.id(), List.of()).stream()
                    .distinct()
                    .toList();
            if (target.state() == RunWaypoint.State.VISITED) {
                assertThat(by)
                        .as("%s; %s", target, said)
                        .contains(target.visits().get(0).drone());
            } else if (target.state() == RunWaypoint.State.UNSERVED) {
                assertThat(target.reason()).isNotBlank();
            }
            assertThat(by.size())
                    .as("%s; %s", target, said)
                    .isGreaterThanOrEqualTo(target.visits().size());
            doubles += Math.max(0, target.visits().size() - 1);
        }
        assertThat(state.counts().doubles()).isEqualTo(doubles);
    }

    /** The same inputs give the same decisions. */
    void replays() {
        RunState again = first;
        for (int i = 0; i < journal.size(); i++) {
            OperationDecision<RunState, RunInput> decision = new MissionRunOperation().decide(again, journal.get(i));
            assertThat(decision).isEqualTo(decisions.get(i));
            again = decision.next();
        }
    }
}
