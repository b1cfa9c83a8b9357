package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.ReplanCause;
import org.dronemap.cognitive.operation.run.model.ReplanProposal;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunSettings;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.cognitive.replan.LiveAssignment;
import org.dronemap.cognitive.replan.ReplanSituation;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Requests a re-planning of a mission run when there is cause for one, from how things stand now. */
final class ReplanScheduler {
    /** Till a plan at once can be flown. */
    private static final Duration AT_ONCE = Duration.ofSeconds(2);
    /** The same, after a search. */
    private static final Duration BESIDE_SEARCH = Duration.ofSeconds(3);

    private static final Duration UNTIL_HELD = Duration.ofSeconds(3);
    /** For one that joins to be held and heard. */
    private static final Duration UNTIL_JOINED = Duration.ofSeconds(15);

    private ReplanScheduler() {}

    static void requestIfNeeded(RunTransition draft, List<DroneObservation> looks) {
        Instant after = draft.clock().plansAfter();
        boolean waits = draft.request() != null
                || draft.plansNothing()
                || (after != null && draft.now().isBefore(after))
                || draft.drones().stream().anyMatch(drone -> isComing(draft, drone));
        if (draft.causes().isEmpty() || waits) {
            return;
        }
        Map<DroneId, Craft> usable = usable(draft, looks);
        UnflyableWaypoints.settle(draft);
        List<ReplanCause> early = draft.causes().stream()
                .filter(cause -> isEarly(draft, cause, usable))
                .toList();
        if (early.size() == draft.causes().size()) {
            return;
        }
        List<Waypoint> open = open(draft, usable);
        if (usable.isEmpty() || (open.isEmpty() && areDown(usable.values()))) {
            nobody(draft);
        } else if (!waitsForChanges(draft)) {
            draft.causes().removeAll(early);
            request(draft, looks, new ArrayList<>(usable.values()), open);
            draft.causes().addAll(early);
        }
    }

    private static boolean waitsForChanges(RunTransition draft) {
        return draft.causes().stream().allMatch(ReplanCause::isBetter)
                && draft.drones().stream().anyMatch(ReplanScheduler::isChanging);
    }

    private static boolean areDown(Collection<Craft> crafts) {
        return crafts.stream().noneMatch(craft -> craft.start().airborne());
    }

    /** A plan without the drone that joins would not be for it; others do not wait for it. */
    private static boolean isEarly(RunTransition draft, ReplanCause cause, Map<DroneId, Craft> usable) {
        DroneId id = cause.drone();
        if (cause.trigger() != RunTrigger.JOINED || id == null || usable.containsKey(id)) {
            return false;
        }
        RunDrone drone = draft.drone(id);
        return drone.stage() == RunDroneStage.LANDED
                && Duration.between(drone.since(), draft.now()).compareTo(UNTIL_JOINED) < 0;
    }

    /** It is about to get its part of the present plan. */
    private static boolean isChanging(RunDrone drone) {
        return drone.next() != null && drone.stage() != RunDroneStage.LANDED;
    }

    /** It is worth a moment. */
    private static boolean isComing(RunTransition draft, RunDrone drone) {
        boolean soonHeld = !drone.flags().held()
                && drone.stage().acceptsCommands()
                && Duration.between(drone.since(), draft.now()).compareTo(UNTIL_HELD) < 0;
        return soonHeld || RunCloudLoss.isUnclear(drone);
    }

    /** Waypoints wait until there is somebody again, or the run ends. */
    private static void nobody(RunTransition draft) {
        boolean mayCome = draft.drones().stream()
                .anyMatch(drone -> (drone.stage().acceptsCommands() && drone.stage() != RunDroneStage.LANDED)
                        || drone.stage() == RunDroneStage.SILENT
                        || (drone.stage() == RunDroneStage.RETURNING && RunCloudLoss.hasMissed(drone)));
        if (!mayCome) {
            draft.causes().clear();
        }
    }

    private static void request(
            RunTransition draft, List<DroneObservation> looks, List<Craft> crafts, List<Waypoint> open) {
        ReplanProposal replaced = draft.proposal();
        if (replaced != null) {
            draft.causes().addAll(0, replaced.causes());
            draft.proposal(null);
        }
        RunSettings setting = draft.setting();
        Duration limit = isPatient(draft) ? setting.search() : Duration.ZERO;
        PendingReplan request =
                PendingReplan.of(draft.tally().request(), !limit.isZero(), draft.now(), draft.causes(), crafts);
        Duration horizon = limit.isZero() ? AT_ONCE : limit.plus(BESIDE_SEARCH);
        // What is left may be less than there are drones, and matters more than that each has some of it.
        PlanningProblem problem = new PlanningProblem(
                UnflyableWaypoints.marked(draft, open),
                UnflyableWaypoints.marked(draft, crafts, open),
                DroneObstacles.barriers(draft, looks, crafts),
                setting.wind(),
                setting.objective().withIdleDronesAllowed(),
                setting.rules());
        List<LiveAssignment> live = new ArrayList<>();
        for (Craft craft : crafts) {
            live.add(order(draft, draft.drone(craft.id()), looks, horizon));
        }
        live.addAll(orphans(draft, live));
        draft.request(request);
        draft.causes().clear();
        draft.requestComputation(
                new ReplanComputation(request.number(), new ReplanSituation(problem, live), setting.seed(), limit));
    }

    private static Map<DroneId, Craft> usable(RunTransition draft, List<DroneObservation> looks) {
        Map<DroneId, Craft> usable = new LinkedHashMap<>();
        for (DroneObservation look : looks) {
            RunDrone drone = draft.drone(look.drone());
            if (CraftSnapshots.isUsable(drone, look)) {
                usable.put(drone.id(), CraftSnapshots.now(draft, drone, look));
            }
        }
        return usable;
    }

    private static List<Waypoint> open(RunTransition draft, Map<DroneId, Craft> usable) {
        double elapsed = Duration.between(draft.clock().begun(), draft.now()).toMillis() / 1_000.0;
        List<Waypoint> open = new ArrayList<>();
        for (RunWaypoint target : draft.targets()) {
            boolean assigned = target.state() == RunWaypoint.State.ASSIGNED && usable.containsKey(target.drone());
            if (target.state() != RunWaypoint.State.WAITING && !assigned) {
                continue;
            }
            TimeWindow window = target.waypoint().window();
            if (window.closesSeconds() < elapsed) {
                expire(draft, target);
            } else {
                open.add(shifted(target.waypoint(), elapsed));
            }
        }
        return open;
    }

    private static void expire(RunTransition draft, RunWaypoint target) {
        for (RunDrone drone : draft.drones()) {
            if (drone.orders().contains(target.id())) {
                draft.put(drone.withOrders(drone.orders().stream()
                        .filter(id -> !id.equals(target.id()))
                        .toList()));
            }
        }
        draft.put(target.to(RunWaypoint.State.UNSERVED, null, "Its window closed before anybody came."));
    }

    private static Waypoint shifted(Waypoint waypoint, double elapsed) {
        TimeWindow window = waypoint.window();
        return window.equals(TimeWindow.ALWAYS)
                ? waypoint
                : new Waypoint(
                        waypoint.id(),
                        waypoint.place(),
                        waypoint.task(),
                        waypoint.priority(),
                        new TimeWindow(Math.max(0, window.opensSeconds() - elapsed), window.closesSeconds() - elapsed));
    }

    /** Somebody is asked anyway, or nothing waits for a drone. */
    private static boolean isPatient(RunTransition draft) {
        boolean asked = draft.setting().mode() == RunOrder.ApprovalMode.ASK_FIRST;
        return asked
                || (draft.causes().stream().allMatch(ReplanCause::isPatient)
                        && draft.targets().stream().noneMatch(ReplanScheduler::isNobodys));
    }

    /** What no drone could serve waits for nothing that a plan at once would bring sooner. */
    private static boolean isNobodys(RunWaypoint target) {
        return target.state() == RunWaypoint.State.WAITING && !target.leftOut();
    }

    /** Whose waypoints without a drone were. */
    private static List<LiveAssignment> orphans(RunTransition draft, List<LiveAssignment> live) {
        Map<String, DroneId> whose = new LinkedHashMap<>();
        for (ReplanCause cause : draft.causes()) {
            boolean plans = live.stream().anyMatch(order -> order.drone().equals(cause.drone()));
            if (cause.drone() != null && !plans) {
                cause.orphans().stream()
                        .filter(id -> draft.target(id).state() == RunWaypoint.State.WAITING)
                        .forEach(id -> whose.put(id, cause.drone()));
            }
        }
        Map<DroneId, List<String>> had = new LinkedHashMap<>();
        whose.forEach((id, drone) ->
                had.computeIfAbsent(drone, key -> new ArrayList<>()).add(id));
        return had.entrySet().stream()
                .map(entry -> LiveAssignment.of(entry.getKey(), entry.getValue()))
                .toList();
    }

    private static LiveAssignment order(
            RunTransition draft, RunDrone drone, List<DroneObservation> looks, Duration horizon) {
        Place here = looks.stream()
                .filter(each -> each.drone().equals(drone.id()))
                .findFirst()
                .orElseThrow()
                .place();
        List<String> firm = committed(draft, drone, here, horizon);
        return new LiveAssignment(
                drone.id(),
                firm,
                drone.orders().subList(firm.size(), drone.orders().size()),
                CraftSnapshots.isBusy(drone, here));
    }

    /** What it comes to before it can get anything else; or stands at, where it was stopped. */
    private static List<String> committed(RunTransition draft, RunDrone drone, @Nullable Place here, Duration horizon) {
        if (drone.stage() == RunDroneStage.FLYING && drone.next() == null) {
            return LostDrones.reached(draft, drone, here, horizon);
        }
        return here == null || !drone.stage().mayFly() ? List.of() : WaypointProximity.stoppedAt(draft, drone, here);
    }
}
