package org.dronemap.core.conduct;

import java.time.Clock;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.DroneCandidate;
import org.dronemap.core.virtual.DroneChoice;
import org.dronemap.core.virtual.DroneSelection;
import org.dronemap.core.virtual.ServiceDemand;
import org.dronemap.core.virtual.UnfitCode;
import org.dronemap.core.virtual.UnfitReason;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualFlightIntent;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunAssignment;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.core.virtual.VirtualRunObservation;
import org.dronemap.core.virtual.VirtualRunStep;
import org.dronemap.core.virtual.VirtualTourSection;
import org.jspecify.annotations.Nullable;

/**
 * Runs the missions of all virtual drones step by step, and assigns real drones to those that wait. Owned by the
 * conductor's thread.
 */
final class VirtualRunExecutor {
    private static final int MOST_STEPS = 8;

    private final CloudManager cloud;
    private final VirtualDroneRegistry book;
    private final DroneGateway crew;
    private final VirtualRunMachine machine;
    private final VirtualDroneRights rights;
    private final SeparationBoard board;
    private final Time time;
    private final Clock clock;
    private final StationaryTimer stillness;
    private final LinkLossTimer silence;
    private final ConcurrentHashMap<VirtualDroneId, List<DroneSelection.Unfit>> waitingFor = new ConcurrentHashMap<>();

    /** Services that runs of virtual drones are driven with: state machine, rights and time. */
    record Context(VirtualRunMachine machine, VirtualDroneRights rights, SeparationBoard board, Time time) {}

    VirtualRunExecutor(CloudManager cloud, VirtualDroneRegistry book, DroneGateway crew, Context means) {
        this.cloud = cloud;
        this.book = book;
        this.crew = crew;
        this.machine = means.machine();
        this.rights = means.rights();
        this.board = means.board();
        this.time = means.time();
        this.clock = time.clock();
        this.stillness = new StationaryTimer(time::nanos);
        this.silence = new LinkLossTimer(time::nanos);
    }

    /** Why the drones of the warehouse cannot serve it now; nothing when it does not wait. Any thread. */
    List<DroneSelection.Unfit> waitingFor(VirtualDroneId id) {
        return waitingFor.getOrDefault(id, List.of());
    }

    /**
     * What waits, in its turn, and why that drone could not serve it if it were in the warehouse and nobody had control of
     * it; what it could serve it would be sent to fly at once.
     */
    List<VirtualDroneMatch> prospects(DroneState drone) {
        return book.waiting().stream()
                .filter(waiting ->
                        rights.mayFly(waiting.account()) && rights.mayServe(waiting.organisation(), drone.id()))
                .flatMap(waiting -> Optional.ofNullable(waiting.run())
                        .map(run -> new VirtualDroneMatch(waiting, whyNot(waiting, run, drone)))
                        .stream())
                .toList();
    }

    private Optional<UnfitReason> whyNot(VirtualDrone waiting, VirtualRun run, DroneState drone) {
        List<DroneState> alone = List.of(drone);
        return DroneSelection.of(
                        new ServiceDemand(waiting.needs(), run.tour(), run.flown(), wind(run, alone)),
                        alone,
                        (state, share) -> hindrance(waiting, run, state, share))
                .unfit()
                .stream()
                .map(DroneSelection.Unfit::why)
                .findFirst();
    }

    /** After a restart, before anybody else can command. */
    void restore() {
        for (VirtualDrone drone : book.all()) {
            DroneId bound = drone.boundTo();
            if (bound != null) {
                crew.engage(VirtualLeaseHolders.of(drone), bound);
            }
            drone.recalled().forEach(recalled -> crew.engage(VirtualLeaseHolders.of(drone), recalled));
        }
    }

    /** After a restart that has to do without what was under way. */
    void suspendAll(String why) {
        for (VirtualDrone drone : book.all()) {
            VirtualRun run = drone.run();
            DroneId bound = drone.boundTo();
            if (run != null && drone.isUnderWay()) {
                VirtualDrone suspended = drone.with(run.setAside(why, clock.instant()));
                book.put(bound == null ? suspended : suspended.recalling(bound));
            }
        }
        restore();
    }

    void resume(VirtualDrone start) {
        VirtualDrone now = start;
        for (int step = 0; step < MOST_STEPS; step++) {
            Optional<VirtualDrone> next = step(now);
            if (next.isEmpty()) {
                return;
            }
            now = next.get();
        }
    }

    /** Empty when there is nothing more to do at present. */
    private Optional<VirtualDrone> step(VirtualDrone now) {
        VirtualRun run = now.run();
        VirtualRunAssignment assignment = run == null ? null : run.assignment();
        if (run == null || assignment == null) {
            return Optional.empty();
        }
        VirtualRunStep step = machine.next(run, sight(now, assignment));
        Command command = step.send();
        if (command != null) {
            CommandId id = new CommandId(time.newId());
            book.put(now.with(step.run().given(id, clock.instant())));
            crew.command(VirtualLeaseHolders.of(now), assignment.drone(), id, command);
            return Optional.empty();
        }
        if (step.run().equals(run)) {
            return Optional.empty();
        }
        VirtualDrone next = now.with(step.run());
        leave(
                step.release() == VirtualRunStep.Release.RECALL ? next.recalling(assignment.drone()) : next,
                assignment,
                step);
        return book.find(now.id());
    }

    private void leave(VirtualDrone next, VirtualRunAssignment assignment, VirtualRunStep step) {
        book.put(next);
        if (step.release() == VirtualRunStep.Release.FREE) {
            crew.release(VirtualLeaseHolders.of(next), assignment.drone());
        }
    }

    /** Somebody who goes first commands the drone that serves this one. */
    void interrupt(VirtualDrone drone, String why) {
        VirtualRun run = drone.run();
        VirtualRunAssignment assignment = run == null ? null : run.assignment();
        if (run == null || assignment == null) {
            return;
        }
        VirtualRunStep step = VirtualRunMachine.suspend(run, why, clock.instant());
        leave(drone.with(step.run()), assignment, step);
    }

    /** What all of them mean their drones to do next. */
    void publishIntents() {
        Map<DroneId, FlightIntent> intents = new HashMap<>();
        for (VirtualDrone drone : book.all()) {
            VirtualRun run = drone.run();
            VirtualRunAssignment assignment = run == null ? null : run.assignment();
            if (run != null && assignment != null) {
                VirtualFlightIntent.of(run, assignment).ifPresent(intent -> intents.put(assignment.drone(), intent));
            }
        }
        board.intend(VirtualDrones.FACE, intents);
    }

    private VirtualRunObservation sight(VirtualDrone by, VirtualRunAssignment assignment) {
        GiveWay giveWay = board.giveWay(assignment.drone()).orElse(null);
        DroneState drone = cloud.drone(assignment.drone()).orElse(null);
        CommandId command = assignment.command();
        Optional<CommandRecord> record = command == null ? Optional.empty() : crew.record(command);
        Outcome outcome = record.map(CommandRecord::outcome).orElse(null);
        return new VirtualRunObservation(
                drone,
                crew.whyNotHeld(VirtualLeaseHolders.of(by), assignment.drone()),
                outcome,
                record.isPresent() && outcome == null,
                drone == null ? Duration.ZERO : silence.of(drone),
                drone == null ? Duration.ZERO : stillness.of(drone),
                rights.mayFly(by.account()),
                giveWay,
                clock.instant());
    }

    /** Each takes the best of what is free; what one cannot use is left to the ones behind it. */
    void serveQueue() {
        List<VirtualDrone> waiting = book.waiting();
        waitingFor.keySet().retainAll(waiting.stream().map(VirtualDrone::id).toList());
        for (VirtualDrone drone : waiting) {
            VirtualRun run = drone.run();
            if (run != null) {
                serve(drone, run);
            }
        }
    }

    private void serve(VirtualDrone drone, VirtualRun run) {
        if (!rights.mayFly(drone.account())) {
            book.put(drone.with(machine.stop(run, clock.instant())));
            return;
        }
        List<DroneState> serving = cloud.drones().stream()
                .filter(state ->
                        book.warehouse().contains(state.id()) && rights.mayServe(drone.organisation(), state.id()))
                .toList();
        DroneSelection selection = DroneSelection.of(
                new ServiceDemand(drone.needs(), run.tour(), run.flown(), wind(run, serving)),
                serving,
                (state, share) -> objection(drone, run, state, share));
        waitingFor.put(drone.id(), selection.unfit());
        selection.choice().ifPresent(choice -> bind(drone, run, choice, selection));
    }

    /** Of others' drones nothing is told, not even what wind they feel. */
    private @Nullable Wind wind(VirtualRun run, List<DroneState> drones) {
        int next = Math.min(run.flown(), run.total() - 1);
        return Wind.near(run.tour().waypoints().get(next).point(), drones, clock.instant())
                .orElse(null);
    }

    private Optional<UnfitReason> objection(
            VirtualDrone drone, VirtualRun run, DroneState state, VirtualTourSection share) {
        return crew.whyBusy(state.id())
                .map(held -> UnfitReason.of(new Refusal(OutcomeCode.CONTROL_HELD, held)))
                .or(() -> hindrance(drone, run, state, share));
    }

    /** What speaks against it though nobody has control of it. */
    private Optional<UnfitReason> hindrance(
            VirtualDrone drone, VirtualRun run, DroneState state, VirtualTourSection share) {
        return VirtualRunMachine.avoids(run, state, clock.instant())
                ? Optional.of(
                        UnfitReason.of(UnfitCode.FAILED_BEFORE, "It could not go on with this mission a while ago."))
                : crew.refusal(VirtualLeaseHolders.of(drone), state, new Command.UploadMission(share.mission()))
                        .map(UnfitReason::of);
    }

    private void bind(VirtualDrone drone, VirtualRun run, DroneChoice choice, DroneSelection selection) {
        if (crew.engage(VirtualLeaseHolders.of(drone), choice.chosen()).isPresent()) {
            // Somebody was quicker.
            return;
        }
        Double takeOff = selection.candidates().stream()
                .filter(candidate -> candidate.drone().equals(choice.chosen()))
                .findFirst()
                .map(DroneCandidate::takeOffMeters)
                .orElse(null);
        try {
            book.put(drone.with(run.bound(choice, takeOff, clock.instant())));
        } catch (RuntimeException e) {
            crew.release(VirtualLeaseHolders.of(drone), choice.chosen());
            throw e;
        }
        waitingFor.remove(drone.id());
    }
}
