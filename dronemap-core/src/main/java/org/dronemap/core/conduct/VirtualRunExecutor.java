package org.dronemap.core.conduct;

import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualFlightIntent;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunAssignment;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.core.virtual.VirtualRunObservation;
import org.dronemap.core.virtual.VirtualRunStep;

/**
 * Runs the missions of all virtual drones step by step, each share of a mission by itself. Owned by the conductor's
 * thread.
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

    /** After a restart, before anybody else can command. */
    void restore() {
        for (VirtualDrone drone : book.all()) {
            drone.bound().forEach(bound -> crew.engage(VirtualLeaseHolders.of(drone), bound));
            drone.recalled().forEach(recalled -> crew.engage(VirtualLeaseHolders.of(drone), recalled));
        }
    }

    /** After a restart that has to do without what was under way. */
    void suspendAll(String why) {
        for (VirtualDrone drone : book.all()) {
            if (drone.isUnderWay()) {
                List<VirtualRun> runs = new ArrayList<>();
                for (VirtualRun run : drone.runs()) {
                    runs.add(run.stage().isOver() ? run : run.setAside(why, clock.instant()));
                }
                VirtualDrone suspended = drone.with(runs);
                for (DroneId bound : drone.bound()) {
                    suspended = suspended.recalling(bound);
                }
                book.put(suspended);
            }
        }
        restore();
    }

    void resume(VirtualDrone start) {
        for (int share = 0; share < start.runs().size(); share++) {
            for (int step = 0; step < MOST_STEPS && step(start, share); step++) {
                // Goes on until there is nothing more to do at present.
            }
        }
    }

    /** False when there is nothing more to do at present. */
    private boolean step(VirtualDrone of, int share) {
        VirtualDrone now = book.find(of.id()).orElse(of);
        VirtualRun run = now.runs().get(share);
        VirtualRunAssignment assignment = run.assignment();
        if (assignment == null) {
            return false;
        }
        VirtualRunStep step = machine.next(run, sight(now, assignment));
        Command command = step.send();
        if (command != null) {
            CommandId id = new CommandId(time.newId());
            book.put(now.with(share, step.run().given(id, clock.instant())));
            crew.command(VirtualLeaseHolders.of(now), assignment.drone(), id, command);
            return false;
        }
        if (step.run().equals(run)) {
            return false;
        }
        VirtualDrone next = now.with(share, step.run());
        leave(
                step.release() == VirtualRunStep.Release.RECALL ? next.recalling(assignment.drone()) : next,
                assignment,
                step);
        return true;
    }

    private void leave(VirtualDrone next, VirtualRunAssignment assignment, VirtualRunStep step) {
        book.put(next);
        if (step.release() == VirtualRunStep.Release.FREE) {
            crew.release(VirtualLeaseHolders.of(next), assignment.drone());
        }
    }

    /** Somebody who goes first commands that drone, which serves a share of this one: that share alone waits. */
    void interrupt(VirtualDrone drone, DroneId taken, String why) {
        for (int share = 0; share < drone.runs().size(); share++) {
            VirtualRun run = drone.runs().get(share);
            VirtualRunAssignment assignment = run.assignment();
            if (assignment != null && assignment.drone().equals(taken)) {
                VirtualRunStep step = VirtualRunMachine.suspend(run, why, clock.instant());
                leave(drone.with(share, step.run()), assignment, step);
            }
        }
    }

    /** What all of them mean their drones to do next. */
    void publishIntents() {
        Map<DroneId, FlightIntent> intents = new HashMap<>();
        Set<String> divided = new HashSet<>();
        for (VirtualDrone drone : book.all()) {
            if (drone.runs().size() > 1) {
                divided.add(VirtualLeaseHolders.of(drone).id());
            }
            for (VirtualRun run : drone.runs()) {
                VirtualRunAssignment assignment = run.assignment();
                if (assignment != null) {
                    VirtualFlightIntent.of(run, assignment)
                            .ifPresent(intent -> intents.put(assignment.drone(), intent));
                }
            }
        }
        board.unplanned(divided);
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
}
