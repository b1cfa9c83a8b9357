package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.TrajectoryForecast.Trajectory;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDrone.IssuedCommand;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.BarrierCheck;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Separation;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.mission.Altitude;

/**
 * Keeps the drones of a mission run apart in flight: looks seconds ahead, and holds or moves one of those in conflict.
 * Of two that would come too near to each other one waits until the other has passed.
 */
final class SeparationGuard {
    private static final double AHEAD_SECONDS = 10;
    /** Who goes on must not be stopped again at once. */
    private static final double CLEAR_SECONDS = 14;

    private static final double ROOM_METERS = 2;
    /** Heights wander by so much; layers are exactly as far apart as they must be. */
    private static final double WANDER_METERS = 0.6;
    /** From the decision until it stands, at full speed: so far it goes on while it brakes. */
    static final int STRIDES_TO_STAND = 5;

    /** What must be done within that time must be done now. */
    private static final int STRIDES_TO_ACT = 12;
    /** Within that nobody sets off who still rolls: where it comes to stand is not known. */
    private static final double ROLLS_METERS = 40;
    /** From the decision until it rises. */
    private static final int STRIDES_TO_ARM = 6;
    /** The share of the distance that two who fly by their plans may come to. */
    private static final double AS_PLANNED = 0.7;

    private static final Duration LONGEST_YIELD = Duration.ofSeconds(15);
    /** Below this over its home it lands. */
    private static final double LOWEST_HOLD_METERS = 8;

    private static final double OVER_METERS = 6;
    /** Over its home nobody climbs from here to make room. */
    private static final double HIGHEST_OVER_METERS = 80;

    private static final Duration LONGEST_UNANSWERED = Duration.ofMillis(1_500);
    private static final Duration UNTIL_OVER = Duration.ofSeconds(5);

    private final RunTransition draft;
    private final Map<DroneId, DroneObservation> looks = new HashMap<>();
    private final double horizontal;
    private final double vertical;
    private final TrajectoryForecast near;
    private final TrajectoryForecast far;

    private SeparationGuard(RunTransition draft, List<DroneObservation> seen) {
        this.draft = draft;
        seen.forEach(look -> looks.put(look.drone(), look));
        Separation separation = draft.setting().rules().separation();
        horizontal = separation.horizontalMeters() + ROOM_METERS;
        vertical = separation.verticalMeters() - WANDER_METERS;
        LocalPlane plane =
                new LocalPlane(draft.drones().get(0).craft().finish().place().point());
        near = new TrajectoryForecast(plane, AHEAD_SECONDS);
        far = new TrajectoryForecast(plane, CLEAR_SECONDS);
    }

    static void keepApart(RunTransition draft, List<DroneObservation> looks) {
        SeparationGuard guard = new SeparationGuard(draft, looks);
        List<DroneId> ids = draft.drones().stream().map(RunDrone::id).toList();
        for (int i = 0; i < ids.size(); i++) {
            for (int j = i + 1; j < ids.size(); j++) {
                guard.pair(draft.drone(ids.get(i)), draft.drone(ids.get(j)));
            }
        }
        draft.drones().stream().filter(drone -> waitsToRise(draft, drone)).forEach(guard::checkTakeOff);
        draft.drones().stream().filter(SeparationGuard::isAboutToGoOn).forEach(guard::checkDeparture);
        draft.drones().stream()
                .filter(drone -> drone.flags().waitsFor() != null && !waitsToRise(draft, drone))
                .filter(drone -> !(draft.isPaused() && drone.stage() == RunDroneStage.HOLDING))
                .forEach(guard::checkHold);
    }

    private void pair(RunDrone one, RunDrone other) {
        if (!mayMove(one) && !mayMove(other)) {
            return;
        }
        List<Trajectory> mine = near.of(draft, one, looks.get(one.id()));
        List<Trajectory> yours = near.of(draft, other, looks.get(other.id()));
        if (!isConflict(mine, yours)) {
            return;
        }
        // Who comes home by itself is the last to be stopped, and not before it must be.
        boolean soon = isConflict(soon(mine), soon(yours));
        boolean homeward = mayOnlyComeHome(one) || mayOnlyComeHome(other);
        boolean solved = waits(one, mine, other, yours, RunDroneStage.FLYING)
                || dodge(one, other, true)
                || (homeward && !soon)
                || waits(one, mine, other, yours, RunDroneStage.RETURNING)
                || dodge(one, other, false);
        if (!solved) {
            hold(other, one);
            hold(one, other);
        }
    }

    private static boolean mayOnlyComeHome(RunDrone drone) {
        return drone.stage() == RunDroneStage.RETURNING && drone.flags().waitsFor() == null;
    }

    private static List<Trajectory> soon(List<Trajectory> tracks) {
        return tracks.stream()
                .map(track -> new Trajectory(track.places().subList(0, STRIDES_TO_ACT + 1)))
                .toList();
    }

    /** One of the two that is in that stage stands still until the other one has passed, where that helps. */
    private boolean waits(
            RunDrone one, List<Trajectory> mine, RunDrone other, List<Trajectory> yours, RunDroneStage stage) {
        if (other.stage() == stage && mayHold(other) && !isConflict(mine, TrajectoryForecast.stopping(yours))) {
            hold(other, one);
            return true;
        }
        boolean first = one.stage() == stage && mayHold(one) && !isConflict(TrajectoryForecast.stopping(mine), yours);
        if (first) {
            hold(one, other);
        }
        return first;
    }

    /** One of the two gets out of the way, whose step is smaller. */
    private boolean dodge(RunDrone one, RunDrone other, boolean entirely) {
        Optional<AvoidanceMove> mine = step(one, entirely);
        Optional<AvoidanceMove> yours = step(other, entirely);
        boolean second = yours.isPresent() && (mine.isEmpty() || yours.get().isBetterThan(mine.get()));
        RunDrone who = second ? other : one;
        RunDrone whom = second ? one : other;
        Optional<AvoidanceMove> step = second ? yours : mine;
        step.ifPresent(found -> {
            Duration takes = Duration.ofMillis(Math.round(1_000 * found.seconds()));
            sendAside(yielding(who, whom.id()).busy(draft.now().plus(takes)), found.to());
            String words = who.name() + " " + found.words() + ", to make room for " + whom.name() + ".";
            draft.explain(RunTrigger.TOO_NEAR, who.id(), words);
        });
        return step.isPresent();
    }

    private void sendAside(RunDrone drone, Place to) {
        draft.sendCommand(
                drone,
                IssuedCommand.Purpose.DODGE,
                new Command.GoTo(to.point(), new Altitude(to.altitudeAmslMeters(), Altitude.Reference.AMSL)));
    }

    /** Who is on its way home stays so: that goes on when it is clear. */
    private RunDrone yielding(RunDrone drone, DroneId whom) {
        boolean home = drone.stage() == RunDroneStage.RETURNING;
        return drone.with(drone.flags().waitsFor(whom))
                .to(home ? RunDroneStage.RETURNING : RunDroneStage.HOLDING, draft.now());
    }

    /** {@code entirely}: only one that leaves it clear of all, and of none that is on its way home. */
    private Optional<AvoidanceMove> step(RunDrone drone, boolean entirely) {
        DroneObservation look = looks.get(drone.id());
        if ((entirely && drone.stage() == RunDroneStage.RETURNING)
                || !mayDodge(drone)
                || look == null
                || look.place() == null) {
            return Optional.empty();
        }
        List<Trajectory> others = draft.drones().stream()
                .filter(other -> !other.id().equals(drone.id()))
                .flatMap(other -> near.of(draft, other, looks.get(other.id())).stream())
                .toList();
        return AvoidanceMove.of(
                        drone,
                        look.place(),
                        draft.setting().barriers(),
                        near,
                        track -> others.stream()
                                .mapToDouble(other -> track.clearance(other, horizontal, vertical))
                                .min()
                                .orElse(Double.POSITIVE_INFINITY))
                .filter(found -> !entirely || found.isClear());
    }

    private boolean mayMove(RunDrone drone) {
        return mayHold(drone) || mayDodge(drone);
    }

    /** It flies its mission or waits in the air, is ours, and is on no way out already. */
    private boolean mayDodge(RunDrone drone) {
        DroneObservation look = looks.get(drone.id());
        if (mayHold(drone)) {
            return look != null && look.canGoTo();
        }
        return look != null
                && (drone.stage() == RunDroneStage.HOLDING || drone.stage() == RunDroneStage.RETURNING)
                && isFree(drone)
                && look.isLive()
                && look.holder() == null
                && look.waits()
                && look.canGoTo()
                && look.airborne();
    }

    /** Nothing is under way to it; or the step that it was told should show by now, and another one is looked for. */
    private boolean isFree(RunDrone drone) {
        IssuedCommand errand = drone.issuedCommand();
        return errand == null
                ? !isBusy(drone)
                : errand.kind() == IssuedCommand.Purpose.DODGE
                        && Duration.between(errand.at(), draft.now()).compareTo(LONGEST_UNANSWERED) > 0;
    }

    private boolean isConflict(List<Trajectory> some, List<Trajectory> others) {
        return some.stream().anyMatch(one -> others.stream().anyMatch(other -> isConflict(one, other)));
    }

    private boolean isConflict(Trajectory one, Trajectory other) {
        return one.meets(other, horizontal, vertical) && !one.leaves(other, horizontal, vertical);
    }

    /** It flies its mission or home, and is ours to stop. */
    private boolean mayHold(RunDrone drone) {
        DroneObservation look = looks.get(drone.id());
        return look != null
                && drone.issuedCommand() == null
                && look.isLive()
                && look.holder() == null
                && look.airborne()
                && (drone.stage() == RunDroneStage.FLYING ? look.isOnMission() : isHomeward(drone, look));
    }

    /** On its way home, and not about to touch the ground there. */
    private static boolean isHomeward(RunDrone drone, DroneObservation look) {
        Double above = look.aboveHomeMeters();
        return drone.stage() == RunDroneStage.RETURNING
                && look.comesDown()
                && look.canReturn()
                && above != null
                && above > LOWEST_HOLD_METERS;
    }

    private boolean isBusy(RunDrone drone) {
        Instant until = drone.attempts().notBefore();
        return until != null && draft.now().isBefore(until);
    }

    private void hold(RunDrone drone, RunDrone other) {
        if (!mayHold(drone)) {
            return;
        }
        draft.sendCommand(yielding(drone, other.id()), IssuedCommand.Purpose.HOLD, new Command.PauseMission());
        draft.explain(RunTrigger.TOO_NEAR, drone.id(), drone.name() + " waits until " + other.name() + " has passed.");
    }

    private static boolean waitsToRise(RunTransition draft, RunDrone drone) {
        Sortie sortie = drone.sortie();
        boolean due = drone.stage() == RunDroneStage.READY && sortie != null && LaunchTiming.isDue(draft, sortie);
        return due || drone.stage() == RunDroneStage.ARMING;
    }

    /** Nobody takes off into the way of one who is in the air. */
    private void checkTakeOff(RunDrone drone) {
        DroneObservation look = looks.get(drone.id());
        Place place = look == null ? null : look.place();
        if (look == null || place == null || look.isArmed()) {
            return;
        }
        Trajectory at = far.mission(drone, place);
        List<Trajectory> up = List.of(at, at.after(STRIDES_TO_ARM));
        Optional<RunDrone> above = draft.drones().stream()
                .filter(other -> !other.id().equals(drone.id()) && other.stage().mayFly())
                .filter(other -> far.of(draft, other, looks.get(other.id())).stream()
                        .anyMatch(way -> up.stream().anyMatch(mine -> isInTheWay(mine, way, other))))
                .findFirst();
        DroneId yields = above.map(RunDrone::id).orElse(null);
        if (!Objects.equals(yields, drone.flags().waitsFor())) {
            draft.put(drone.with(drone.flags().waitsFor(yields)));
            above.filter(other -> drone.flags().waitsFor() == null)
                    .map(other -> drone.name() + " waits on the ground until " + other.name() + " has passed.")
                    .ifPresent(words -> draft.explain(RunTrigger.TOO_NEAR, drone.id(), words));
        }
    }

    /** Who flies by its plan was planned for: no room is left beside the least distance. */
    private boolean isInTheWay(Trajectory mine, Trajectory way, RunDrone other) {
        boolean planned = switch (other.stage()) {
            case FLYING, STARTING, CONTINUING -> true;
            default -> false;
        };
        return mine.clearance(way, horizontal, vertical) < (planned ? AS_PLANNED : 1);
    }

    /** Of two who wait for each other one moves. */
    private boolean isWaitedForByEarlier(RunDrone drone) {
        DroneId other = drone.flags().waitsFor();
        return other != null
                && drone.id().equals(draft.drone(other).flags().waitsFor())
                && other.value().compareTo(drone.id().value()) < 0;
    }

    private static boolean isAboutToGoOn(RunDrone drone) {
        return drone.stage() == RunDroneStage.CONTINUING && drone.issuedCommand() == null && drone.next() == null;
    }

    /** With a new mission it does not fly into the way of one who is not where plans take it to be. */
    private void checkDeparture(RunDrone drone) {
        DroneObservation look = looks.get(drone.id());
        if (look == null || look.place() == null || !look.waits() || !look.airborne()) {
            return;
        }
        Trajectory mine = far.mission(drone, look.place());
        draft.drones().stream()
                .filter(other -> !other.id().equals(drone.id()) && other.stage().mayFly())
                .filter(other -> far.of(draft, other, looks.get(other.id())).stream()
                        .anyMatch(way -> isInTheWay(mine, way, other) || (look.isStillMoving() && isNear(mine, way))))
                .findFirst()
                .ifPresent(other -> draft.put(yielding(drone, other.id())));
    }

    private boolean isNear(Trajectory mine, Trajectory way) {
        return mine.stopping(0).meets(way.stopping(0), ROLLS_METERS, vertical);
    }

    private void checkHold(RunDrone drone) {
        DroneObservation look = looks.get(drone.id());
        boolean home = drone.stage() == RunDroneStage.RETURNING;
        if (!(home || drone.stage() == RunDroneStage.HOLDING) || look == null || look.place() == null) {
            draft.put(drone.with(drone.flags().waitsFor(null)));
        } else if (drone.issuedCommand() == null && look.waits() && drone.next() == null && !isBusy(drone)) {
            goOn(drone, look.place(), isClear(drone, look, look.place()));
        } else if (isHomeward(drone, look)) {
            draft.put(drone.issuedCommand() == null ? drone.with(drone.flags().waitsFor(null)) : drone);
        }
    }

    private boolean isClear(RunDrone drone, DroneObservation look, Place place) {
        boolean home = drone.stage() == RunDroneStage.RETURNING;
        boolean rolls = look.isStillMoving() && !home;
        Trajectory mine = home ? far.homeward(drone, place) : far.mission(drone, place);
        return draft.drones().stream()
                .filter(other -> !other.id().equals(drone.id()))
                .flatMap(other -> far.of(draft, other, looks.get(other.id())).stream())
                .allMatch(way -> isPassable(mine, way) && !(rolls && isNear(mine, way)));
    }

    /** Whoever is on its way home is called again. */
    private void goOn(RunDrone drone, Place place, boolean clear) {
        boolean late = Duration.between(drone.since(), draft.now()).compareTo(LONGEST_YIELD) > 0;
        if (clear) {
            RunDrone free = drone.with(drone.flags().waitsFor(null));
            draft.put(drone.stage() == RunDroneStage.RETURNING ? free : free.to(RunDroneStage.CONTINUING, draft.now()));
        } else if (late) {
            late(drone, place);
        }
    }

    /** Apart all along, or never nearer than they are now: who came too near already may leave. */
    private boolean isPassable(Trajectory mine, Trajectory way) {
        double now = mine.stopping(0).clearance(way.stopping(0), horizontal, vertical);
        return mine.clearance(way, horizontal, vertical) >= Math.min(1, now - TrajectoryForecast.LEAVING);
    }

    /** Whoever is on its way home comes over those who do not pass; others get another way. */
    private void late(RunDrone drone, Place place) {
        if (drone.stage() != RunDroneStage.RETURNING) {
            draft.put(drone.with(drone.flags().waitsFor(null)));
            draft.addCause(RunTrigger.TOO_NEAR, drone.id(), drone.name() + " cannot pass; another way is looked for.");
            return;
        }
        Place higher = place.at(place.altitudeAmslMeters() + OVER_METERS);
        boolean may = new BarrierCheck(draft.setting().barriers(), drone.craft())
                .fault(new TimedPlace(place, 0), new TimedPlace(higher, 1), false)
                .isEmpty();
        RunDrone again = drone.to(RunDroneStage.RETURNING, draft.now());
        boolean low = place.altitudeAmslMeters() - drone.craft().homeAmslMeters() < HIGHEST_OVER_METERS;
        if (may && low && !isWaitedForByEarlier(drone)) {
            sendAside(again.busy(draft.now().plus(UNTIL_OVER)), higher);
            draft.explain(
                    RunTrigger.TOO_NEAR, drone.id(), drone.name() + " climbs to come home over those who do not pass.");
        } else {
            draft.put(again);
        }
    }
}
