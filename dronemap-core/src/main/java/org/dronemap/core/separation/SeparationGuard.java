package org.dronemap.core.separation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Keeps all drones apart in flight: looks seconds ahead along what each may do, and has one of two that would come too
 * near wait until the other has passed, or step aside where waiting does not help.
 */
public final class SeparationGuard {
    /** What must be done within that time must be done now. */
    private static final int STRIDES_TO_ACT = 12;

    private static final Duration LONGEST_UNANSWERED = Duration.ofMillis(1_500);

    private final SeparationRound round;

    private SeparationGuard(SeparationRound round) {
        this.round = round;
    }

    /** {@code before}: who gave way until now. */
    public static SeparationDecision decide(AirspacePicture picture, Map<DroneId, Yielding> before) {
        SeparationRound round = new SeparationRound(picture, before);
        YieldingReview.review(round);
        SeparationGuard guard = new SeparationGuard(round);
        guard.pairs(picture.drones());
        guard.clearWays(picture.drones());
        new DepartureGuard(round).check();
        return round.decision();
    }

    /** Of thousands that are in the air few can be moved: two of which neither can are not looked at. */
    private void pairs(List<TrackedDrone> drones) {
        boolean[] moves = new boolean[drones.size()];
        List<Integer> movable = new ArrayList<>();
        for (int i = 0; i < moves.length; i++) {
            moves[i] = mayMove(drones.get(i));
            if (moves[i]) {
                movable.add(i);
            }
        }
        for (int i = 0; i < moves.length && !movable.isEmpty(); i++) {
            if (moves[i]) {
                for (TrackedDrone other : drones.subList(i + 1, drones.size())) {
                    pair(drones.get(i), other);
                }
            } else {
                for (int j : movable) {
                    if (j > i) {
                        pair(drones.get(i), drones.get(j));
                    }
                }
            }
        }
    }

    private void pair(TrackedDrone one, TrackedDrone other) {
        if (round.areFar(one, other) || (!mayMove(one) && !mayMove(other))) {
            return;
        }
        List<Track> mine = round.near(one);
        List<Track> yours = round.near(other);
        Separation least = round.least(one, other);
        if (!isConflict(mine, yours, least)) {
            return;
        }
        if (!solve(one, mine, other, yours)) {
            hold(other, one);
            hold(one, other);
        }
    }

    /** Who comes home by itself is the last to be stopped, and not before it must be. */
    private boolean solve(TrackedDrone one, List<Track> mine, TrackedDrone other, List<Track> yours) {
        boolean known = waits(one, mine, other, yours, new Waiting(false, true))
                || dodge(one, other, Reach.LASTING)
                || waits(one, mine, other, yours, new Waiting(false, false))
                || dodge(one, other, Reach.CLEAR);
        if (known) {
            return true;
        }
        boolean homeward = mayOnlyComeHome(one) || mayOnlyComeHome(other);
        if (homeward && !isConflict(soon(mine), soon(yours), round.least(one, other))) {
            return true;
        }
        return waits(one, mine, other, yours, new Waiting(true, false)) || dodge(one, other, Reach.BEST);
    }

    private static boolean isConflict(List<Track> some, List<Track> others, Separation least) {
        return some.stream().anyMatch(one -> others.stream().anyMatch(other -> one.conflicts(other, least)));
    }

    private boolean mayOnlyComeHome(TrackedDrone drone) {
        return drone.comesDown() && round.yielding(drone) == null;
    }

    private static List<Track> soon(List<Track> tracks) {
        return tracks.stream().map(track -> track.until(STRIDES_TO_ACT)).toList();
    }

    /** One of the two that is on its mission, or on its way home, stands until the other one has passed, where that helps. */
    private boolean waits(TrackedDrone one, List<Track> mine, TrackedDrone other, List<Track> yours, Waiting as) {
        if (mayWait(other, yours, as) && !isConflict(mine, SeparationRound.stopping(yours), round.least(one, other))) {
            hold(other, one);
            return true;
        }
        boolean first =
                mayWait(one, mine, as) && !isConflict(SeparationRound.stopping(mine), yours, round.least(one, other));
        if (first) {
            hold(one, other);
        }
        return first;
    }

    private boolean mayWait(TrackedDrone drone, List<Track> ways, Waiting as) {
        return drone.comesDown() == as.homeward()
                && mayHold(drone)
                && (!as.lasting()
                        || SeparationRound.stopping(ways).stream()
                                .allMatch(way -> round.lastingClearance(drone, round.standing(way)) >= 1));
    }

    /**
     * Kind of drone that is asked to wait.
     *
     * @param homeward one that comes home
     * @param lasting only one that stands in nobody's way for as long as it may have to
     */
    private record Waiting(boolean homeward, boolean lasting) {}

    /** Quality that a step aside has to have. */
    private enum Reach {
        /** Clear of all for as long as it may have to stand there. */
        LASTING,
        /** Clear of all in the next seconds. */
        CLEAR,
        /** The best that there is. */
        BEST
    }

    /** Who stands for another one makes way early for those whose ways lead there. */
    private void clearWays(List<TrackedDrone> drones) {
        for (TrackedDrone drone : drones) {
            Yielding own = round.yielding(drone);
            if (own != null && own.isOrdered() && !own.give().clear() && drone.waits() && mayDodge(drone)) {
                drones.stream()
                        .filter(other -> !other.id().equals(drone.id()) && isUnderWay(other))
                        .filter(other -> round.standsInTheWay(drone, other))
                        .findFirst()
                        .ifPresent(other -> step(drone, Reach.LASTING).ifPresent(found -> move(drone, other, found)));
            }
        }
    }

    private static boolean isUnderWay(TrackedDrone drone) {
        return drone.isLive() && drone.state().airborne() && (isOnMission(drone) || drone.isHomeward());
    }

    private void hold(TrackedDrone drone, TrackedDrone other) {
        if (mayHold(drone)) {
            round.command(
                    drone,
                    round.give(other, GiveWay.Manner.STOP, null),
                    0,
                    drone.isLed() ? comeToStand(drone) : new Command.PauseMission(),
                    drone.name() + " waits until " + other.name() + " has passed.");
        }
    }

    /** Who goes to a place that it was told flies no mission that could be paused: it goes only so far as it brakes. */
    private Command comeToStand(TrackedDrone drone) {
        Track way = SeparationRound.stopping(round.near(drone)).get(0);
        return round.goTo(way.samples().get(way.samples().size() - 1));
    }

    /** One of the two gets out of the way, whose step is smaller. */
    private boolean dodge(TrackedDrone one, TrackedDrone other, Reach reach) {
        Optional<EvasiveMove> mine = step(one, reach);
        Optional<EvasiveMove> yours = step(other, reach);
        boolean second = yours.isPresent() && (mine.isEmpty() || yours.get().isBetterThan(mine.get()));
        TrackedDrone who = second ? other : one;
        TrackedDrone whom = second ? one : other;
        Optional<EvasiveMove> step = second ? yours : mine;
        step.ifPresent(found -> move(who, whom, found));
        return step.isPresent();
    }

    private void move(TrackedDrone who, TrackedDrone whom, EvasiveMove step) {
        round.move(who, whom, step);
    }

    /** Who is on its way home is moved last. */
    private Optional<EvasiveMove> step(TrackedDrone drone, Reach reach) {
        TrackSample here = round.near.here(drone);
        if ((reach != Reach.BEST && mayOnlyComeHome(drone)) || here == null || !mayDodge(drone)) {
            return Optional.empty();
        }
        boolean lasting = reach == Reach.LASTING;
        return EvasiveMove.of(
                        drone,
                        here,
                        lasting ? round.lasting : round.near,
                        there -> round.mayGo(drone, there),
                        track -> lasting
                                ? round.lastingClearance(drone, track)
                                : round.clearance(drone, track, round::near))
                .filter(found -> reach == Reach.BEST || found.isClear());
    }

    private boolean mayMove(TrackedDrone drone) {
        return mayHold(drone) || mayDodge(drone);
    }

    /** It flies its mission or home, and is ours to stop. */
    private boolean mayHold(TrackedDrone drone) {
        boolean free = drone.handling() == Handling.COMMANDED
                && drone.hovers()
                && drone.isLive()
                && drone.state().airborne()
                && !drone.isCommanded();
        Yielding own = round.yielding(drone);
        boolean ordered = own != null && own.isOrdered() && !own.isUnheeded(round.picture.now());
        return free && !ordered && (isOnMission(drone) || drone.isHomeward());
    }

    private static boolean isOnMission(TrackedDrone drone) {
        FlightIntent.@Nullable Step step = drone.step();
        if (step == FlightIntent.Step.GO) {
            return drone.isLed();
        }
        return drone.isOnMission()
                && (step == null || step == FlightIntent.Step.FLY || step == FlightIntent.Step.GO_ON);
    }

    /** It flies its mission or waits in the air, is ours, and is on no way out already. */
    private boolean mayDodge(TrackedDrone drone) {
        if (!drone.canGoTo()) {
            return false;
        }
        return mayHold(drone)
                || (drone.handling() == Handling.COMMANDED
                        && drone.isLive()
                        && drone.state().airborne()
                        && drone.waits()
                        && isStandingForUs(drone)
                        && isFree(drone));
    }

    private boolean isStandingForUs(TrackedDrone drone) {
        return drone.step() == FlightIntent.Step.STAND
                || drone.step() == FlightIntent.Step.COME_HOME
                || round.yielding(drone) != null;
    }

    /** Nothing is under way to it; or the step that it was told should show by now, and another one is looked for. */
    private boolean isFree(TrackedDrone drone) {
        if (drone.isCommanded()) {
            return false;
        }
        Yielding own = round.yielding(drone);
        return own == null
                || !own.isBusy(round.picture.now())
                || Duration.between(own.give().since(), round.picture.now()).compareTo(LONGEST_UNANSWERED) > 0;
    }
}
