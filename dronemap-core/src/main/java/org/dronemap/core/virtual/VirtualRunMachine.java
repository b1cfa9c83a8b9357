package org.dronemap.core.virtual;

import static org.dronemap.core.virtual.VirtualRunStage.ARMING;
import static org.dronemap.core.virtual.VirtualRunStage.DONE;
import static org.dronemap.core.virtual.VirtualRunStage.FAILED;
import static org.dronemap.core.virtual.VirtualRunStage.FLYING;
import static org.dronemap.core.virtual.VirtualRunStage.GIVING_UP;
import static org.dronemap.core.virtual.VirtualRunStage.RETURNING;
import static org.dronemap.core.virtual.VirtualRunStage.STARTING;
import static org.dronemap.core.virtual.VirtualRunStage.STOPPED;
import static org.dronemap.core.virtual.VirtualRunStage.STOPPING;
import static org.dronemap.core.virtual.VirtualRunStage.SUSPENDED;
import static org.dronemap.core.virtual.VirtualRunStep.Release.FREE;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.MissionProgress;
import org.jspecify.annotations.Nullable;

/**
 * State machine of a virtual drone's run: from its state and an observation of its real drone to the next step. It
 * touches nothing. What is already so is never commanded, so that a run goes on after a restart wherever it was.
 */
public final class VirtualRunMachine {
    /** A silent drone counts as flying for so long, beside what its mission still takes. */
    public static final Duration USUAL_SILENCE = Duration.ofMinutes(2);

    private static final int MOST_TRIES = 3;
    private static final int MOST_FAILURES = 5;
    private static final Duration AVOIDED = Duration.ofMinutes(10);
    /** From an order that was carried out until that shows. */
    private static final Duration UNTIL_SEEN = Duration.ofSeconds(30);

    private static final Duration LONGEST_STILL_ON_ITS_WAY_HOME = Duration.ofSeconds(90);
    /** Before it is called home once more. */
    private static final Duration BETWEEN_CALLS = Duration.ofSeconds(5);

    private final SilentVirtualRunRules silent;

    /** {@code silence}: so long a drone that is not heard counts as flying, beside what its mission still takes. */
    public VirtualRunMachine(Duration silence) {
        silent = new SilentVirtualRunRules(silence);
    }

    public VirtualRunStep next(VirtualRun run, VirtualRunObservation sight) {
        VirtualRunAssignment assignment = run.assignment();
        if (assignment == null) {
            return VirtualRunStep.unchanged(run);
        }
        DroneState drone = sight.drone();
        if (drone == null) {
            return replace(run, assignment, "The drone was taken away.", sight, FREE);
        }
        if (sight.whyNotHeld() != null) {
            return suspend(run, sight.whyNotHeld(), sight.now());
        }
        if (drone.link().state() == LinkState.LOST) {
            return silent.next(run, assignment, drone, sight);
        }
        if (drone.link().state() != LinkState.LIVE || !drone.capabilities().known()) {
            return VirtualRunStep.unchanged(run);
        }
        if (!sight.mayFly() && run.stage().compareTo(RETURNING) < 0) {
            return VirtualRunStep.unchanged(
                    run.to(STOPPING, "Its owner may not fly virtual drones any more.", sight.now()));
        }
        return sight.underWay()
                ? VirtualRunStep.unchanged(progress(run, assignment, drone))
                : VirtualGivingWay.next(progress(run, assignment, drone), drone, sight)
                        .orElseGet(() -> go(run, assignment, drone, sight));
    }

    /** Somebody who goes first commands the drone now: the run waits for its user. */
    public static VirtualRunStep suspend(VirtualRun run, String why, Instant now) {
        return VirtualRunStep.leave(
                run.unbound(
                        SUSPENDED,
                        "Somebody who goes first has taken the drone. Resume when another one shall go on, or stop.",
                        why,
                        now),
                FREE);
    }

    /** The user wants it to end. */
    public VirtualRun stop(VirtualRun run, Instant now) {
        if (run.stage().isOver() || run.stage() == STOPPING) {
            return run;
        }
        return run.stage().isBound()
                ? run.to(STOPPING, "It is stopped: the drone comes home.", now)
                : run.unbound(STOPPED, "It was stopped.", run.detail(), now);
    }

    /** The user wants it to go on; empty when it does not wait for that. */
    public Optional<VirtualRun> resume(VirtualRun run, Instant now) {
        return run.stage() == SUSPENDED || run.stage() == FAILED ? Optional.of(run.resumed(now)) : Optional.empty();
    }

    private VirtualRunStep go(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        return switch (run.stage()) {
            case UPLOADING -> upload(run, assignment, drone, sight);
            case ARMING -> VirtualArming.next(run, assignment, drone, sight);
            case STARTING -> start(run, assignment, drone, sight);
            case FLYING -> fly(run, assignment, drone, sight);
            case RETURNING -> comeHome(run, assignment, drone, sight);
            default -> bringHome(run, assignment, drone, sight);
        };
    }

    private static VirtualRunStep upload(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        if (sight.outcome() instanceof Outcome.Succeeded) {
            return VirtualRunStep.unchanged(run.to(ARMING, "The drone has the mission and is armed.", sight.now()));
        }
        if (Boolean.TRUE.equals(drone.armed())) {
            return replace(run, assignment, "The drone was armed by somebody else.", sight, FREE);
        }
        if (sight.outcome() != null) {
            return tryAgain(run, assignment, drone, sight);
        }
        return VirtualRunStep.send(
                run, new Command.UploadMission(share(run, assignment).mission()));
    }

    private static VirtualRunStep start(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        boolean armed = Boolean.TRUE.equals(drone.armed());
        boolean up = assignment.takeOffMeters() == null || drone.airborne();
        if (armed && isOnMission(drone) && up) {
            return VirtualRunStep.unchanged(run.to(FLYING, "The drone flies the mission.", sight.now()));
        }
        if (Boolean.FALSE.equals(drone.armed())) {
            return armAgain(run, assignment, sight);
        }
        if (sight.outcome() instanceof Outcome.Succeeded) {
            return since(assignment, sight).compareTo(UNTIL_SEEN) < 0
                    ? VirtualRunStep.unchanged(run)
                    : tryAgain(run, assignment, drone, sight);
        }
        if (sight.outcome() != null) {
            return tryAgain(run, assignment, drone, sight);
        }
        return armed
                ? VirtualRunStep.send(run, new Command.StartMission(run.onCloudLoss()))
                : VirtualRunStep.unchanged(run);
    }

    /** Vehicles disarm by themselves, and take the order to start even then. */
    private static VirtualRunStep armAgain(
            VirtualRun run, VirtualRunAssignment assignment, VirtualRunObservation sight) {
        boolean started = sight.outcome() == null || sight.outcome() instanceof Outcome.Succeeded;
        String why = started ? "It was disarmed before it started." : reason(sight.outcome());
        return assignment.tries() + 1 < MOST_TRIES
                ? VirtualRunStep.unchanged(run.to(ARMING, assignment.tries() + 1, why, sight.now()))
                : replace(
                        run.failedTry(why, sight.now()),
                        assignment,
                        "The drone could not be made to fly.",
                        sight,
                        FREE);
    }

    private static VirtualRunStep fly(
            VirtualRun before, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        MissionProgress mission = drone.mission();
        if (mission.items() == null || (mission.current() == null && !isBackFromAll(drone))) {
            // After a restart, until the vehicle has been asked.
            return VirtualRunStep.unchanged(before);
        }
        VirtualRun run = progress(before, assignment, drone);
        if (run.flown() == run.total()) {
            return VirtualRunStep.unchanged(
                    run.to(RETURNING, "All waypoints are flown; the drone comes back.", sight.now()));
        }
        if (Boolean.FALSE.equals(drone.armed())) {
            return replace(run, assignment, VirtualHomecoming.endedEarly(drone), sight, FREE);
        }
        if (share(run, assignment).isOnBoard(drone.mission()).equals(Optional.of(false))) {
            return giveUp(run, "The drone carries another mission now; it is called home.", sight);
        }
        Optional<Steering> steering = drone.capabilities().steering(drone.mode());
        if (drone.capabilities().isSafe(drone.mode())) {
            return replace(
                    run,
                    assignment,
                    "The drone went home or down (" + drone.mode() + "), which its mission did not ask for.",
                    sight,
                    FREE);
        }
        if (steering.equals(Optional.of(Steering.STICKS))) {
            // No mission ends in one: a pilot has it, who may not be called home by anybody.
            return suspend(run, "Somebody steers the drone by hand.", sight.now());
        }
        return VirtualFlightFaults.ofOneUnderWay(run, assignment, drone, sight)
                .map(why -> giveUp(run, why, sight))
                .orElseGet(() -> VirtualRunStep.unchanged(run));
    }

    private static VirtualRunStep comeHome(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        if (Boolean.FALSE.equals(drone.armed())) {
            return VirtualRunStep.leave(
                    run.unbound(DONE, "Done: all waypoints are flown and the drone is back.", null, sight.now()), FREE);
        }
        Optional<VirtualRunStep> there = atHome(
                run, assignment, drone, sight, words -> done(run, "Done: all waypoints are flown. " + words, sight));
        if (there.isPresent()) {
            return there.get();
        }
        if (sight.still().compareTo(LONGEST_STILL_ON_ITS_WAY_HOME) > 0) {
            return done(run, "All waypoints are flown; the drone is stuck on its way.", sight);
        }
        boolean hangs = drone.mission().complete()
                && drone.airborne()
                && !drone.capabilities().isSafe(drone.mode());
        return hangs && since(assignment, sight).compareTo(BETWEEN_CALLS) > 0
                ? VirtualRunStep.send(run, homeward(drone))
                : VirtualRunStep.unchanged(run);
    }

    private static VirtualRunStep done(VirtualRun run, String words, VirtualRunObservation sight) {
        return VirtualRunStep.leave(run.unbound(DONE, words, null, sight.now()), FREE);
    }

    /** {@code ends}: by a sentence of what the drone does at home; empty: it is not there, or lands by itself. */
    private static Optional<VirtualRunStep> atHome(
            VirtualRun run,
            VirtualRunAssignment assignment,
            DroneState drone,
            VirtualRunObservation sight,
            Function<String, VirtualRunStep> ends) {
        if (!VirtualHomecoming.standsAtHome(drone, sight)) {
            return VirtualHomecoming.circling(drone).map(ends);
        }
        boolean asked = assignment.command() != null && since(assignment, sight).compareTo(BETWEEN_CALLS) < 0;
        return Optional.of(VirtualHomecoming.whyStaysArmed(drone)
                .map(ends)
                .orElseGet(() ->
                        asked ? VirtualRunStep.unchanged(run) : VirtualRunStep.send(run, new Command.Disarm(false))));
    }

    private static VirtualRunStep bringHome(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        if (Boolean.FALSE.equals(drone.armed())) {
            return run.stage() == STOPPING
                    ? VirtualRunStep.leave(
                            run.unbound(STOPPED, "It was stopped; the drone is down.", run.detail(), sight.now()), FREE)
                    : replace(run, assignment, "The drone could not go on.", sight, FREE);
        }
        Optional<VirtualRunStep> there =
                atHome(run, assignment, drone, sight, words -> replace(run, assignment, words, sight, FREE));
        if (there.isPresent()) {
            return there.get();
        }
        if (sight.still().compareTo(LONGEST_STILL_ON_ITS_WAY_HOME) > 0) {
            return replace(run, assignment, "The drone is stuck on its way home.", sight, FREE);
        }
        boolean called =
                assignment.command() != null && since(assignment, sight).compareTo(BETWEEN_CALLS) < 0;
        boolean onItsWay = drone.capabilities().isSafe(drone.mode());
        if (onItsWay && run.stage() == GIVING_UP) {
            String why = "The drone could not go on and is on its way home.";
            return replace(run, assignment, why, sight, FREE);
        }
        if (called || onItsWay) {
            return VirtualRunStep.unchanged(run);
        }
        boolean away = drone.airborne() || drone.identification().kind().neverFlies();
        return VirtualRunStep.send(run, away ? homeward(drone) : new Command.Disarm(false));
    }

    static Command homeward(DroneState drone) {
        return drone.capabilities().commands().contains(Capability.RETURN_TO_LAUNCH)
                ? new Command.ReturnToLaunch()
                : new Command.Land();
    }

    private static VirtualRun progress(VirtualRun run, VirtualRunAssignment assignment, DroneState drone) {
        if (run.stage() != FLYING && run.stage() != STOPPING && run.stage() != GIVING_UP) {
            return run;
        }
        VirtualTourSection share = share(run, assignment);
        return share.isOnBoard(drone.mission()).equals(Optional.of(true))
                ? run.flown(isBackFromAll(drone) ? share.end() : share.flown(drone.mission()))
                : run;
    }

    /** Flown to the end and put down, maybe while nobody here listened: then it names no item any more. */
    private static boolean isBackFromAll(DroneState drone) {
        return drone.mission().complete() && Boolean.FALSE.equals(drone.armed());
    }

    private static VirtualTourSection share(VirtualRun run, VirtualRunAssignment assignment) {
        return run.tour().share(assignment.first(), assignment.takeOffMeters());
    }

    static boolean isOnMission(DroneState drone) {
        return drone.capabilities().steering(drone.mode()).equals(Optional.of(Steering.MISSION));
    }

    private static Duration since(VirtualRunAssignment assignment, VirtualRunObservation sight) {
        return Duration.between(assignment.changedAt(), sight.now());
    }

    static VirtualRunStep tryAgain(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        String why = reason(sight.outcome());
        if (assignment.tries() + 1 < MOST_TRIES) {
            return VirtualRunStep.unchanged(run.failedTry(why, sight.now()));
        }
        VirtualRun failed = run.failedTry(why, sight.now());
        return Boolean.FALSE.equals(drone.armed())
                ? replace(failed, assignment, "The drone could not be made to fly.", sight, FREE)
                : giveUp(failed, "The drone could not be made to fly; it is brought to rest.", sight);
    }

    static String reason(@Nullable Outcome outcome) {
        String why = outcome == null ? null : outcome.reason();
        return why == null ? "It did not show in time." : why;
    }

    static VirtualRunStep giveUp(VirtualRun run, String why, VirtualRunObservation sight) {
        return VirtualRunStep.unchanged(run.to(GIVING_UP, why, sight.now()));
    }

    /** Another drone shall do the rest. */
    static VirtualRunStep replace(
            VirtualRun run,
            VirtualRunAssignment assignment,
            String why,
            VirtualRunObservation sight,
            VirtualRunStep.Release release) {
        if (run.stage() == STOPPING) {
            return VirtualRunStep.leave(
                    run.unbound(STOPPED, "It was stopped. " + why, run.detail(), sight.now()), release);
        }
        if (run.failures() + 1 >= MOST_FAILURES) {
            return VirtualRunStep.leave(
                    run.unbound(
                            FAILED,
                            MOST_FAILURES + " drones could not go on; look at why, then resume. " + why,
                            run.detail(),
                            sight.now()),
                    release);
        }
        return VirtualRunStep.leave(
                run.requeued(
                        assignment.drone(),
                        sight.now().plus(AVOIDED),
                        why + " Another one is looked for; it begins at waypoint " + (run.flown() + 1) + ".",
                        sight.now()),
                release);
    }

    /** Drones that are not asked again yet. */
    public static boolean avoids(VirtualRun run, DroneState drone, Instant now) {
        Instant until = run.avoided().get(drone.id());
        return until != null && until.isAfter(now);
    }
}
