package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.ReplanCause;
import org.dronemap.cognitive.operation.run.model.ReplanProposal;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunExplanation;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunPool;
import org.dronemap.cognitive.operation.run.model.RunSettings;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The state of a mission run: drones, waypoints, settings and pending re-planning; stored with each decision.
 *
 * @param clock what it goes by
 * @param request the plan that is being computed
 * @param causes what a plan has to be asked for yet
 * @param proposal the plan that waits for an answer
 * @param explanations the newest {@value #MOST_EXPLANATIONS}, oldest first
 * @param stopping all are called home
 * @param end how it ended, as a sentence; null: it goes on
 * @param wording number of the sentences in which it explains itself, which are part of what its journal is compared by;
 *     null: it began before they had one
 */
@Stored(
        names = "id clock setting targets drones counts request causes proposal explanations stopping end wording",
        later = "wording")
public record RunState(
        OperationId id,
        Clock clock,
        RunSettings setting,
        List<RunWaypoint> targets,
        List<RunDrone> drones,
        Counts counts,
        @Nullable PendingReplan request,
        List<ReplanCause> causes,
        @Nullable ReplanProposal proposal,
        List<RunExplanation> explanations,
        boolean stopping,
        @Nullable String end,
        @Nullable Integer wording) {
    public static final int MOST_EXPLANATIONS = 50;

    /** Number of the sentences in which a run that begins now explains itself. */
    public static final int WORDING = 2;

    /**
     * Times and deadlines of the run.
     *
     * @param begun zero of the clock that waypoints' windows go by
     * @param launched the first drone was started, or may have been
     * @param plansAfter no plan is asked for before
     * @param lossAfter after a restart, no drone that has not told all since counts as lost before
     * @param pausedSince all wait where they are; null: they go on
     */
    @Stored(names = "begun launched asksAfter hearsAfter pausedSince")
    public record Clock(
            Instant begun,
            boolean launched,
            @Nullable Instant plansAfter,
            @Nullable Instant lossAfter,
            @Nullable Instant pausedSince) {
        Clock launched(Instant at) {
            return new Clock(at, true, plansAfter, lossAfter, pausedSince);
        }

        Clock withPlansAfter(Instant after) {
            return new Clock(begun, launched, after, lossAfter, pausedSince);
        }

        Clock withLossAfter(Instant after) {
            return new Clock(begun, launched, plansAfter, after, pausedSince);
        }

        Clock paused(@Nullable Instant since) {
            return new Clock(begun, launched, plansAfter, lossAfter, since);
        }
    }

    /**
     * Counters of the run: commands, requests, sorties, plans and visits.
     *
     * @param misses plans in a row that could not be flown
     * @param doubles visits of waypoints that were visited already
     */
    @Stored(names = "commands requests sorties replans misses proposals explanations doubles")
    public record Counts(
            int commands,
            int requests,
            int sorties,
            int replans,
            int misses,
            int proposals,
            int explanations,
            int doubles) {
        static final Counts NONE = new Counts(0, 0, 0, 0, 0, 0, 0, 0);
    }

    public RunState {
        targets = List.copyOf(targets);
        drones = List.copyOf(drones);
        causes = List.copyOf(causes);
        explanations = List.copyOf(explanations);
    }

    public static RunState begin(RunOrder order) {
        return RunInitialState.of(order);
    }

    /**
     * It began when its sentences were others, and a replay of its journal comes to those again; {@code number}: of the first
     * wording that has them as they are now.
     */
    boolean isWordedBefore(int number) {
        return wording == null || wording < number;
    }

    public boolean isOver() {
        return end != null;
    }

    public Optional<RunDrone> drone(DroneId id) {
        return drones.stream().filter(drone -> drone.id().equals(id)).findFirst();
    }

    public Optional<RunWaypoint> target(String id) {
        return targets.stream().filter(target -> target.id().equals(id)).findFirst();
    }

    /** So many drones of the pool may join in the place of lost ones; 0: none has to. */
    public int vacancies() {
        RunPool pool = setting.pool();
        if (pool == null || isOver() || stopping || clock.pausedSince() != null) {
            return 0;
        }
        long flying = drones.stream().filter(RunPoolDrones::counts).count();
        boolean open = targets.stream().anyMatch(target -> !target.state().isSettled());
        return open && flying < drones.size() ? (int) Math.max(0, pool.upTo() - flying) : 0;
    }

    public long count(RunWaypoint.State state) {
        return targets.stream().filter(target -> target.state() == state).count();
    }

    /** When a drone is to be at its end, by the plan that it flies; empty: it flies none. */
    public Optional<Instant> due(DroneId id) {
        return drone(id)
                .filter(drone -> drone.stage().acceptsCommands() && drone.stage() != RunDroneStage.LANDED)
                .map(RunDrone::latest)
                .map(sortie -> sortie.moment(sortie.tour().endsSeconds()));
    }

    /** When a waypoint is to be visited; empty: nobody is on the way. */
    public Optional<Instant> due(RunWaypoint target) {
        return target.state() != RunWaypoint.State.ASSIGNED || target.drone() == null
                ? Optional.empty()
                : drone(target.drone()).map(RunDrone::latest).flatMap(sortie -> sortie.due(target.id()));
    }
}
