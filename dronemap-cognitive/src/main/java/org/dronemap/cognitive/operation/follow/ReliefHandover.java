package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.follow.FollowSeparation;

/** Hands a follow over from its drone to a relief drone, and sends replaced drones home. */
final class ReliefHandover {
    private ReliefHandover() {}

    /** It sets off. */
    static FollowState sent(FollowState state, FollowInput.SendRelief relieve) {
        FollowState relief = state.relief(relieve.chosen(), relieve.at());
        String why = state.stage() == FollowStage.RETURNING
                ? relief.droneName() + " comes in the place of " + state.droneName() + "."
                : state.droneName() + " runs low; " + relief.droneName() + " comes to replace it.";
        return state.with(state.crew().sending(relief))
                .saying(relieve.at(), why + " " + relieve.chosen().why());
    }

    /** Said once, until one comes after all. */
    static FollowState unrelieved(FollowState state, FollowInput.NoReliefAvailable unrelieved) {
        return state.crew().alone() || !state.isRelievable()
                ? state
                : state.with(state.crew().toldAlone())
                        .saying(
                                unrelieved.at(),
                                "No other drone can replace " + state.droneName() + ". " + unrelieved.why());
    }

    /** It has to leave, and it is not said that nobody shall be followed any more. */
    static FollowState leaving(FollowState before, FollowState next, boolean anybody) {
        boolean vacant = before.stage() == FollowStage.TRACKING
                && next.stage() == FollowStage.RETURNING
                && (anybody || before.isRelieved());
        return vacant ? next.with(next.crew().vacant(true)) : next;
    }

    /** The same with what the others became, when the one that leads came there from that stage. */
    static FollowState settled(
            FollowState before,
            FollowState state,
            List<FollowState> others,
            Instant at,
            List<FollowInput.OtherDrone> seen,
            FollowSeparation apart) {
        FollowState next = state;
        List<FollowState> left = new ArrayList<>();
        for (FollowState other : others) {
            FollowState now = isCalledOff(before, next, other)
                    ? other.to(FollowStage.RETURNING, at, other.droneName() + " flies home as well.")
                    : other;
            next = passedOn(next, now);
            if (now.isOver()) {
                boolean failed = now.crew().number() > next.crew().number();
                next = failed ? next.with(next.crew().failing(now.drone())) : next;
            } else {
                left.add(now.silently());
            }
        }
        next = left.equals(next.crew().others()) ? next : next.with(next.crew().with(left));
        return handedOver(next, at, seen, ReliefState.nearMeters(apart));
    }

    private static boolean isCalledOff(FollowState before, FollowState leader, FollowState other) {
        boolean ends = switch (leader.stage()) {
            case RETURNING -> !leader.crew().vacant();
            // Its drone was lost, and whoever is followed has to be followed on.
            case OVER ->
                before.stage() != FollowStage.TRACKING && !before.crew().vacant();
            case SUSPENDED -> true;
            case ALLOCATED, STARTING, TRACKING, PAUSED -> false;
        };
        return ends && other.comes(leader);
    }

    private static FollowState passedOn(FollowState leader, FollowState other) {
        FollowState next = leader;
        for (FollowState.Notice told : other.told()) {
            next = next.saying(told.at(), told.words().replace(FollowCommands.IT_IS_OVER, "."));
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
        if (state.stage() == FollowStage.RETURNING && state.crew().vacant()) {
            return ready(state)
                    .map(other -> handOver(
                            state.saying(
                                    at, other.droneName() + " has taken over; " + state.droneName() + " goes on home."),
                            other,
                            at))
                    .orElse(state);
        }
        if (!state.isOver()) {
            return state;
        }
        List<FollowState> others = state.crew().others();
        return ready(state)
                .map(other -> lead(state.saying(at, other.droneName() + " has taken over."), other, others, at))
                .or(() -> others.stream()
                        .max(Comparator.comparing(other -> other.comes(state)))
                        .map(other -> lead(state, other, others, at)))
                .orElse(state);
    }

    /** In the air and led. */
    private static Optional<FollowState> ready(FollowState leader) {
        return leader.crew().others().stream()
                .filter(other -> other.comes(leader) && other.stage() == FollowStage.TRACKING)
                .findFirst();
    }

    private static FollowState handOver(FollowState leader, FollowState other, Instant at) {
        List<FollowState> all = new ArrayList<>(leader.crew().others());
        all.add(leader.silently().with(ReliefState.ofNumber(leader.crew().number())));
        return lead(leader, other, all, at);
    }

    private static FollowState lead(FollowState before, FollowState other, List<FollowState> all, Instant at) {
        List<FollowState> others =
                all.stream().filter(one -> !one.drone().equals(other.drone())).toList();
        return other.leads(before, at, before.crew().ledBy(other.crew().number(), others));
    }
}
