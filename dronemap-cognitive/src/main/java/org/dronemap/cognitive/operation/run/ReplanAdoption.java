package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.ReplanCause;
import org.dronemap.cognitive.operation.run.model.ReplanProposal;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.plan.MissionWriter;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Decides what becomes of a computed re-planning of a mission run: computed again, proposed to users, or applied. */
final class ReplanAdoption {
    private static final Duration BETWEEN_TRIES = Duration.ofSeconds(3);
    private static final int MOST_MISSES = 20;
    /** A search for something better is begun again so often at most. */
    private static final int MOST_STALE_SEARCHES = 4;
    /** A better plan is worth turning drones for from this share of its cost on. */
    private static final double WORTH_TURNING = 0.02;

    private ReplanAdoption() {}

    static void planComputed(RunTransition draft, RunInput.ReplanEnded input) {
        PendingReplan request = draft.request();
        if (request == null || request.number() != input.request() || draft.stopping()) {
            return;
        }
        draft.request(null);
        ReplanResult result = input.result();
        if (result == null) {
            retryLater(draft, request, "No plan could be computed: " + input.why());
            return;
        }
        Optional<String> fault = fault(draft, request, result);
        if (fault.isPresent()) {
            retryLater(draft, request, "There is no plan yet that can be flown: " + fault.get());
        } else if (!ReplanFreshness.isFresh(draft, request, result)) {
            stale(draft, request);
        } else if (request.better()) {
            better(draft, request, result);
        } else {
            proposeOrApply(draft, request, result);
        }
    }

    private static void proposeOrApply(RunTransition draft, PendingReplan request, ReplanResult result) {
        boolean asks = draft.setting().mode() == RunOrder.ApprovalMode.ASK_FIRST && !request.approved();
        if (asks && changes(result)) {
            propose(draft, request, result);
            return;
        }
        apply(draft, request, result);
        if (!request.searched() && !draft.setting().search().isZero()) {
            draft.causes().add(ReplanCause.BETTER);
        }
    }

    private static Optional<String> fault(RunTransition draft, PendingReplan request, ReplanResult result) {
        if (!result.canBeFlown()) {
            return Optional.of(result.faults().get(0));
        }
        return request.crafts().stream()
                .flatMap(craft -> tour(result.plan(), craft)
                        .flatMap(tour -> new MissionWriter(
                                        craft, draft.drone(craft.id()).profile().kind(), draft::task)
                                .fault(tour))
                        .stream())
                .findFirst();
    }

    private static Optional<Tour> tour(Plan plan, Craft craft) {
        return plan.tours().stream()
                .filter(tour -> tour.drone().equals(craft.id()))
                .findFirst();
    }

    /** The same causes are asked for again after a while: what is in the way now may not be then. */
    private static void retryLater(RunTransition draft, PendingReplan request, String words) {
        int misses = draft.tally().countFailedPlan();
        boolean last = misses == MOST_MISSES;
        if (!request.better() && (misses == 1 || last)) {
            draft.explain(request.first().trigger(), request.first().drone(), words);
        }
        if (!request.better() && misses < MOST_MISSES) {
            draft.causes().addAll(0, request.causes());
            request.causes().stream()
                    .filter(cause -> misses > 1 && cause.trigger() == RunTrigger.LOW_BATTERY)
                    .forEach(cause -> callHome(draft, cause.drone()));
        }
        draft.clock(draft.clock().withPlansAfter(draft.now().plus(BETWEEN_TRIES)));
    }

    /** Nothing better can be planned for one whose charge gives in. */
    private static void callHome(RunTransition draft, @Nullable DroneId low) {
        if (low != null
                && draft.drone(low).stage().acceptsCommands()
                && draft.drone(low).stage().mayFly()) {
            RunDrone drone = draft.drone(low);
            String words = "No plan brings " + drone.name() + " home with its charge; it is called home.";
            DroneWithdrawal.callHome(draft, drone, RunTrigger.LOW_BATTERY, words);
        }
    }

    /** Something happened meanwhile. */
    private static void stale(RunTransition draft, PendingReplan request) {
        if (!request.better()) {
            draft.causes().addAll(0, request.causes());
        } else if (draft.tally().countFailedPlan() < MOST_STALE_SEARCHES) {
            draft.causes().add(ReplanCause.BETTER);
        }
    }

    private static boolean changes(ReplanResult result) {
        return !result.changes().moved().isEmpty() || !result.changes().drones().isEmpty();
    }

    private static void better(RunTransition draft, PendingReplan request, ReplanResult result) {
        int unserved = result.after().unserved() - result.before().unserved();
        boolean cheaper = result.after().cost() < result.before().cost() * (1 - WORTH_TURNING);
        if (draft.causes().isEmpty() && (unserved < 0 || (unserved == 0 && cheaper))) {
            apply(draft, request, result);
        }
    }

    private static void propose(RunTransition draft, PendingReplan request, ReplanResult result) {
        int number = draft.tally().proposal();
        String words =
                "Proposal " + number + ", which waits for an answer: " + PlanChangeMessages.of(draft, request, result);
        draft.proposal(new ReplanProposal(number, request.at(), request.causes(), result, words));
        draft.explain(request.first(), result, words);
    }

    private static void apply(RunTransition draft, PendingReplan request, ReplanResult result) {
        List<String> turned = new ArrayList<>();
        Plan plan = result.plan();
        for (Craft craft : request.crafts()) {
            RunDrone drone = draft.drone(craft.id());
            draft.put(drone.withOrders(ReplanFreshness.remaining(draft, plan, craft.id())));
        }
        for (Craft craft : request.crafts()) {
            Optional<Tour> tour = tour(plan, craft).map(each -> ReplanFreshness.remaining(draft, each));
            if (TourAssigner.assign(draft, request, craft, tour.orElse(null))) {
                turned.add(draft.drone(craft.id()).name());
            }
        }
        plan.unserved().stream()
                .map(left -> draft.target(left.waypoint()).leftOut(left.why()))
                .filter(target -> !draft.target(target.id()).state().isSettled())
                .forEach(draft::put);
        draft.tally().replan();
        draft.explain(
                request.first(),
                result,
                PlanChangeMessages.of(draft, request, result) + PlanChangeMessages.turned(turned));
    }
}
