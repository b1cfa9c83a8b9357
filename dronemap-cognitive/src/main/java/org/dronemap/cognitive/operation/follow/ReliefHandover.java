package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.separation.Separation;

/** Hands a follow over from its drone to a relief drone, and sends replaced drones home. */
final class ReliefHandover {
    private ReliefHandover() {}

    /** It sets off. */
    static FollowState sendRelief(FollowState state, FollowInput.SendRelief relieve) {
        FollowState relief = state.relief(relieve.chosen(), relieve.at());
        String why = state.stage() == FollowStage.RETURNING
                ? relief.droneName() + " comes in the place of " + state.droneName() + "."
                : state.droneName() + " runs low; " + relief.droneName() + " comes to replace it.";
        return state.with(state.reliefOrNone().sending(relief))
                .withNotice(relieve.at(), why + " " + relieve.chosen().why());
    }

    /** Said once, until one comes after all. */
    static FollowState reportNoRelief(FollowState state, FollowInput.NoReliefAvailable unrelieved) {
        return state.reliefOrNone().aloneReported() || !state.isRelievable()
                ? state
                : state.with(state.reliefOrNone().withAloneReported())
                        .withNotice(
                                unrelieved.at(),
                                "No other drone can replace " + state.droneName() + ". " + unrelieved.why());
    }

    /** It has to leave, and it is not said that nobody shall be followed any more. */
    static FollowState markVacancy(FollowState before, FollowState next, boolean anybody) {
        boolean vacant = before.stage() == FollowStage.TRACKING
                && next.stage() == FollowStage.RETURNING
                && (anybody || before.isRelieved());
        return vacant ? next.with(next.reliefOrNone().vacant(true)) : next;
    }

    /** The same with what the others became, when the one that leads came there from that stage. */
    static FollowState updateReliefs(
            FollowState before,
            FollowState state,
            List<FollowState> others,
            Instant at,
            List<FollowInput.OtherDrone> seen,
            Separation apart) {
        FollowState next = state;
        List<FollowState> left = new ArrayList<>();
        for (FollowState other : others) {
            FollowState now = isCalledOff(before, next, other)
                    ? other.to(FollowStage.RETURNING, at, other.droneName() + " flies home as well.")
                    : other;
            next = copyNotices(next, now);
            if (now.isOver()) {
                boolean failed =
                        now.reliefOrNone().number() > next.reliefOrNone().number();
                next = failed ? next.with(next.reliefOrNone().failing(now.drone())) : next;
            } else {
                left.add(now.withoutNotices());
            }
        }
        next = left.equals(next.reliefOrNone().others())
                ? next
                : next.with(next.reliefOrNone().with(left));
        return handedOver(next, at, seen, ReliefState.nearMeters(apart));
    }

    private static boolean isCalledOff(FollowState before, FollowState leader, FollowState other) {
        boolean ends = switch (leader.stage()) {
            case RETURNING -> !leader.reliefOrNone().vacant();
            // Its drone was lost, and whoever is followed has to be followed on.
            case OVER ->
                before.stage() != FollowStage.TRACKING && !before.reliefOrNone().vacant();
            case SUSPENDED -> true;
            case ALLOCATED, STARTING, TRACKING, PAUSED -> false;
        };
        return ends && other.isComing(leader);
    }

    private static FollowState copyNotices(FollowState leader, FollowState other) {
        FollowState next = leader;
        for (FollowState.Notice told : other.notices()) {
            next = next.withNotice(told.at(), told.words().replace(FollowCommands.IT_IS_OVER, "."));
        }
        return next;
    }

    private static FollowState handedOver(
            FollowState state, Instant at, List<FollowInput.OtherDrone> seen, double near) {
        if (state.stage() == FollowStage.TRACKING) {
            return ready(state)
                    .filter(other -> seen.stream()
                            .filter(one -> one.drone().equals(other.drone()))
                            .anyMatch(one -> one.apartMeters() != null && one.apartMeters() <= near))
                    .map(other -> handOver(
                            state.to(
                                    FollowStage.RETURNING,
                                    at,
                                    other.droneName() + " has taken over; " + state.droneName() + " flies home."),
                            other,
                            at))
                    .orElse(state);
        }
        if (state.stage() == FollowStage.RETURNING && state.reliefOrNone().vacant()) {
            return ready(state)
                    .map(other -> handOver(
                            state.withNotice(
                                    at, other.droneName() + " has taken over; " + state.droneName() + " goes on home."),
                            other,
                            at))
                    .orElse(state);
        }
        if (!state.isOver()) {
            return state;
        }
        List<FollowState> others = state.reliefOrNone().others();
        return ready(state)
                .map(other -> lead(state.withNotice(at, other.droneName() + " has taken over."), other, others, at))
                .or(() -> others.stream()
                        .max(Comparator.comparing(other -> other.isComing(state)))
                        .map(other -> lead(state, other, others, at)))
                .orElse(state);
    }

    /** In the air and led. */
    private static Optional<FollowState> ready(FollowState leader) {
        return leader.reliefOrNone().others().stream()
                .filter(other -> other.isComing(leader) && other.stage() == FollowStage.TRACKING)
                .findFirst();
    }

    private static FollowState handOver(FollowState leader, FollowState other, Instant at) {
        List<FollowState> all = new ArrayList<>(leader.reliefOrNone().others());
        all.add(leader.withoutNotices()
                .with(ReliefState.ofNumber(leader.reliefOrNone().number())));
        return lead(leader, other, all, at);
    }

    private static FollowState lead(FollowState before, FollowState other, List<FollowState> all, Instant at) {
        List<FollowState> others =
                all.stream().filter(one -> !one.drone().equals(other.drone())).toList();
        return other.assumeLead(
                before,
                at,
                before.reliefOrNone().withLeader(other.reliefOrNone().number(), others));
    }
}
