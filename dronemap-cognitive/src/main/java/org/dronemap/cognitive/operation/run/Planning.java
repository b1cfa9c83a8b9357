package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Problem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.cognitive.problem.Window;
import org.dronemap.cognitive.replan.LiveOrder;
import org.dronemap.cognitive.replan.Situation;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Asks for a plan when one is needed, for how things stand now. */
final class Planning {
    /** Till a plan at once can be flown. */
    private static final Duration AT_ONCE = Duration.ofSeconds(2);
    /** The same, after a search. */
    private static final Duration BESIDE_SEARCH = Duration.ofSeconds(3);

    private static final Duration UNTIL_HELD = Duration.ofSeconds(3);
    /** For one that joins to be held and heard. */
    private static final Duration UNTIL_JOINED = Duration.ofSeconds(15);

    private Planning() {}

    static void ask(Draft draft, List<Look> looks) {
        Instant after = draft.clock().asksAfter();
        boolean waits = draft.request() != null
                || draft.plansNothing()
                || (after != null && draft.now().isBefore(after))
                || draft.drones().stream().anyMatch(drone -> isComing(draft, drone));
        if (draft.causes().isEmpty() || waits) {
            return;
        }
        Map<DroneId, Craft> usable = usable(draft, looks);
        List<Cause> early = draft.causes().stream()
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

    private static boolean waitsForChanges(Draft draft) {
        return draft.causes().stream().allMatch(Cause::isBetter)
                && draft.drones().stream().anyMatch(Planning::isChanging);
    }

    private static boolean areDown(Collection<Craft> crafts) {
        return crafts.stream().noneMatch(craft -> craft.start().airborne());
    }

    /** A plan without the drone that joins would not be for it; others do not wait for it. */
    private static boolean isEarly(Draft draft, Cause cause, Map<DroneId, Craft> usable) {
        DroneId id = cause.drone();
        if (cause.trigger() != Trigger.JOINED || id == null || usable.containsKey(id)) {
            return false;
        }
        RunDrone drone = draft.drone(id);
        return drone.stage() == DroneStage.LANDED
                && Duration.between(drone.since(), draft.now()).compareTo(UNTIL_JOINED) < 0;
    }

    /** It is about to get its part of the present plan. */
    private static boolean isChanging(RunDrone drone) {
        return drone.next() != null && drone.stage() != DroneStage.LANDED;
    }

    /** It is worth a moment. */
    private static boolean isComing(Draft draft, RunDrone drone) {
        boolean soonHeld = !drone.signs().held()
                && drone.stage().takesOrders()
                && Duration.between(drone.since(), draft.now()).compareTo(UNTIL_HELD) < 0;
        return soonHeld || Absence.isUnclear(drone);
    }

    /** Waypoints wait until there is somebody again, or the run ends. */
    private static void nobody(Draft draft) {
        boolean mayCome = draft.drones().stream()
                .anyMatch(drone -> (drone.stage().takesOrders() && drone.stage() != DroneStage.LANDED)
                        || drone.stage() == DroneStage.SILENT
                        || (drone.stage() == DroneStage.RETURNING && Absence.hasMissed(drone)));
        if (!mayCome) {
            draft.causes().clear();
        }
    }

    private static void request(Draft draft, List<Look> looks, List<Craft> crafts, List<Waypoint> open) {
        Proposal replaced = draft.proposal();
        if (replaced != null) {
            draft.causes().addAll(0, replaced.causes());
            draft.proposal(null);
        }
        Setting setting = draft.setting();
        Duration limit = isPatient(draft) ? setting.search() : Duration.ZERO;
        Request request = Request.of(draft.tally().request(), !limit.isZero(), draft.now(), draft.causes(), crafts);
        Duration horizon = limit.isZero() ? AT_ONCE : limit.plus(BESIDE_SEARCH);
        // What is left may be less than there are drones, and matters more than that each has some of it.
        Problem problem = new Problem(
                open,
                crafts,
                Obstacles.barriers(draft, looks, crafts),
                setting.wind(),
                setting.objective().leavingDrones(),
                setting.rules());
        List<LiveOrder> live = new ArrayList<>();
        for (Craft craft : crafts) {
            live.add(order(draft, draft.drone(craft.id()), looks, horizon));
        }
        live.addAll(orphans(draft, live));
        draft.request(request);
        draft.causes().clear();
        draft.compute(new Replan(request.number(), new Situation(problem, live), setting.seed(), limit));
    }

    private static Map<DroneId, Craft> usable(Draft draft, List<Look> looks) {
        Map<DroneId, Craft> usable = new LinkedHashMap<>();
        for (Look look : looks) {
            RunDrone drone = draft.drone(look.drone());
            if (Crafts.isUsable(drone, look)) {
                usable.put(drone.id(), Crafts.now(draft, drone, look));
            }
        }
        return usable;
    }

    private static List<Waypoint> open(Draft draft, Map<DroneId, Craft> usable) {
        double elapsed = Duration.between(draft.clock().begun(), draft.now()).toMillis() / 1_000.0;
        List<Waypoint> open = new ArrayList<>();
        for (Target target : draft.targets()) {
            boolean assigned = target.state() == Target.State.ASSIGNED && usable.containsKey(target.drone());
            if (target.state() != Target.State.WAITING && !assigned) {
                continue;
            }
            Window window = target.waypoint().window();
            if (window.closesSeconds() < elapsed) {
                expire(draft, target);
            } else {
                open.add(shifted(target.waypoint(), elapsed));
            }
        }
        return open;
    }

    private static void expire(Draft draft, Target target) {
        for (RunDrone drone : draft.drones()) {
            if (drone.orders().contains(target.id())) {
                draft.put(drone.ordered(drone.orders().stream()
                        .filter(id -> !id.equals(target.id()))
                        .toList()));
            }
        }
        draft.put(target.to(Target.State.UNSERVED, null, "Its window closed before anybody came."));
    }

    private static Waypoint shifted(Waypoint waypoint, double elapsed) {
        Window window = waypoint.window();
        return window.equals(Window.ALWAYS)
                ? waypoint
                : new Waypoint(
                        waypoint.id(),
                        waypoint.place(),
                        waypoint.task(),
                        waypoint.priority(),
                        new Window(Math.max(0, window.opensSeconds() - elapsed), window.closesSeconds() - elapsed));
    }

    /** Somebody is asked anyway, or nothing waits for a drone. */
    private static boolean isPatient(Draft draft) {
        boolean asked = draft.setting().mode() == RunOrder.Mode.ASK_FIRST;
        return asked
                || (draft.causes().stream().allMatch(Cause::isPatient)
                        && draft.targets().stream().noneMatch(Planning::isNobodys));
    }

    /** What no drone could serve waits for nothing that a plan at once would bring sooner. */
    private static boolean isNobodys(Target target) {
        return target.state() == Target.State.WAITING && !target.leftOut();
    }

    /** Whose waypoints without a drone were. */
    private static List<LiveOrder> orphans(Draft draft, List<LiveOrder> live) {
        Map<String, DroneId> whose = new LinkedHashMap<>();
        for (Cause cause : draft.causes()) {
            boolean plans = live.stream().anyMatch(order -> order.drone().equals(cause.drone()));
            if (cause.drone() != null && !plans) {
                cause.orphans().stream()
                        .filter(id -> draft.target(id).state() == Target.State.WAITING)
                        .forEach(id -> whose.put(id, cause.drone()));
            }
        }
        Map<DroneId, List<String>> had = new LinkedHashMap<>();
        whose.forEach((id, drone) ->
                had.computeIfAbsent(drone, key -> new ArrayList<>()).add(id));
        return had.entrySet().stream()
                .map(entry -> LiveOrder.of(entry.getKey(), entry.getValue()))
                .toList();
    }

    private static LiveOrder order(Draft draft, RunDrone drone, List<Look> looks, Duration horizon) {
        Place here = looks.stream()
                .filter(each -> each.drone().equals(drone.id()))
                .findFirst()
                .orElseThrow()
                .place();
        List<String> firm = firm(draft, drone, here, horizon);
        return new LiveOrder(
                drone.id(),
                firm,
                drone.orders().subList(firm.size(), drone.orders().size()),
                Crafts.isBusy(drone, here));
    }

    /** What it comes to before it can get anything else; or stands at, where it was stopped. */
    private static List<String> firm(Draft draft, RunDrone drone, @Nullable Place here, Duration horizon) {
        if (drone.stage() == DroneStage.FLYING && drone.next() == null) {
            return Silences.reached(draft, drone, here, horizon);
        }
        return here == null || !drone.stage().mayFly() ? List.of() : Arrival.stoppedAt(draft, drone, here);
    }
}
