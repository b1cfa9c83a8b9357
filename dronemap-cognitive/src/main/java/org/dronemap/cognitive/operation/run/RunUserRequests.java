package org.dronemap.cognitive.operation.run;

import java.util.List;
import org.dronemap.cognitive.operation.run.model.ReplanProposal;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Waypoint;

/** Applies a user's request to the state of a mission run. */
final class RunUserRequests {
    private RunUserRequests() {}

    static void apply(RunTransition draft, RunInput.UserRequest wish) {
        if (wish instanceof RunInput.AddWaypoints add) {
            add.waypoints().forEach(waypoint -> draft.put(RunWaypoint.waiting(waypoint)));
            List<String> ids = add.waypoints().stream().map(Waypoint::id).toList();
            draft.addCause(
                    RunTrigger.WAYPOINTS_ADDED,
                    null,
                    add.by() + " added " + RunMessages.count(ids.size(), "waypoint") + ": " + RunMessages.list(ids)
                            + ".");
        } else if (wish instanceof RunInput.MoveWaypoint move) {
            move(draft, move);
        } else if (wish instanceof RunInput.CancelWaypoint cancel) {
            cancel(draft, cancel);
        } else if (wish instanceof RunInput.AddBarrier add) {
            draft.setting(draft.setting().with(add.barrier()));
            draft.addCause(
                    RunTrigger.FENCE_ADDED,
                    null,
                    add.by() + " added " + add.barrier().words() + ", which drones keep to from now on.");
        } else if (wish instanceof RunInput.AnswerProposal answer) {
            answer(draft, answer);
        } else if (wish instanceof RunInput.Pause || wish instanceof RunInput.Resume) {
            RunPause.apply(draft, wish);
        } else {
            RunMembership.apply(draft, wish);
        }
    }

    private static void move(RunTransition draft, RunInput.MoveWaypoint move) {
        RunWaypoint target = draft.target(move.waypoint());
        Waypoint old = target.waypoint();
        forget(draft, move.waypoint(), false);
        draft.put(draft.target(move.waypoint())
                .with(new Waypoint(old.id(), move.to(), old.task(), old.priority(), old.window())));
        draft.addCause(
                RunTrigger.WAYPOINT_MOVED, target.drone(), move.by() + " moved the waypoint " + move.waypoint() + ".");
    }

    private static void cancel(RunTransition draft, RunInput.CancelWaypoint cancel) {
        RunWaypoint target = draft.target(cancel.waypoint());
        forget(draft, cancel.waypoint(), true);
        draft.put(target.to(RunWaypoint.State.CANCELLED, null, cancel.by() + " cancelled it."));
        draft.addCause(
                RunTrigger.WAYPOINT_CANCELLED,
                target.drone(),
                cancel.by() + " cancelled the waypoint " + cancel.waypoint() + ".");
    }

    /** Whoever passes its old place has visited nothing. */
    private static void forget(RunTransition draft, String waypoint, boolean entirely) {
        for (RunDrone drone : draft.drones()) {
            Sortie sortie = drone.sortie();
            Sortie next = drone.next();
            RunDrone without = drone.withSortie(sortie == null ? null : sortie.without(waypoint), drone.passed())
                    .withNext(next == null ? null : next.without(waypoint));
            draft.put(
                    entirely
                            ? without.withOrders(drone.orders().stream()
                                    .filter(id -> !id.equals(waypoint))
                                    .toList())
                            : without);
        }
    }

    private static void answer(RunTransition draft, RunInput.AnswerProposal answer) {
        ReplanProposal proposal = draft.proposal();
        if (proposal == null || proposal.number() != answer.proposal()) {
            return;
        }
        draft.proposal(null);
        if (answer.accepted()) {
            draft.causes().addAll(proposal.causes());
            draft.addCause(
                    RunTrigger.ANSWERED,
                    null,
                    answer.by() + " said yes to proposal " + proposal.number()
                            + "; it is planned for where the drones are by now.");
        } else {
            draft.explain(RunTrigger.ANSWERED, null, answer.by() + " said no to proposal " + proposal.number() + ".");
        }
    }
}
