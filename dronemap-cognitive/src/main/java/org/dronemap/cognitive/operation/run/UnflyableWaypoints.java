package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.TaskItem;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Skill;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;

/**
 * Keeps waypoints from drones whose vehicles do not fly what is to be done there: only such a waypoint leaves a drone's
 * mission, for another drone that flies it, or for nobody; the drone stays.
 */
final class UnflyableWaypoints {
    /** By which a vehicle says that it does not take an item of a mission. */
    private static final Set<OutcomeCode> OF_AN_ITEM = EnumSet.of(
            OutcomeCode.MISSION_NOT_FOR_VEHICLE,
            OutcomeCode.MISSION_ITEM_NOT_KNOWN,
            OutcomeCode.MISSION_VALUE_NOT_TAKEN,
            OutcomeCode.POSITIONS_NOT_TAKEN);

    private UnflyableWaypoints() {}

    /** True: the drone's next mission has an item that it does not fly, whose waypoint is not its own any more. */
    static boolean foundBefore(RunTransition draft, RunDrone drone, DroneObservation look) {
        DroneObservation.ItemFault fault = look.progress().nextFault();
        Sortie next = drone.next();
        if (fault == null || next == null) {
            return false;
        }
        List<String> waypoints = next.waypointOf(fault.item()).stream().toList();
        withdrawFrom(draft, drone, waypoints, fault.sentence());
        return !waypoints.isEmpty();
    }

    /** True: the vehicle refused an item, which can only be one of those that do more than lead somewhere. */
    static boolean foundByVehicle(RunTransition draft, RunDrone drone, OutcomeCode code, String sentence) {
        Sortie next = drone.next();
        if (next == null || !OF_AN_ITEM.contains(code)) {
            return false;
        }
        List<String> waypoints =
                next.tasks().stream().map(TaskItem::waypoint).distinct().toList();
        withdrawFrom(draft, drone, waypoints, sentence);
        return !waypoints.isEmpty();
    }

    private static void withdrawFrom(RunTransition draft, RunDrone drone, List<String> waypoints, String why) {
        if (waypoints.isEmpty()) {
            return;
        }
        String words = drone.name() + " does not fly "
                + (waypoints.size() == 1 ? "the waypoint " : "the waypoints ") + RunMessages.list(waypoints) + ": "
                + why;
        for (String id : waypoints) {
            RunWaypoint target = draft.target(id);
            if (!target.state().isSettled()) {
                draft.put(target.to(RunWaypoint.State.WAITING, null, words).refusedBy(drone.id()));
            }
        }
        boolean up = drone.stage().mayFly();
        List<String> rest =
                drone.orders().stream().filter(id -> !waypoints.contains(id)).toList();
        RunDrone without = drone.withOrders(rest).withNext(null);
        draft.put(
                up
                        ? without.to(RunDroneStage.HOLDING, draft.now())
                        : without.withSortie(null, 0).to(RunDroneStage.LANDED, draft.now()));
        draft.addCause(RunTrigger.COMMAND_FAILED, drone.id(), words, waypoints);
    }

    /** Those that every drone refused which can still be given anything are left out for good. */
    static void settle(RunTransition draft) {
        List<DroneId> left = draft.drones().stream()
                .filter(drone -> drone.stage().acceptsCommands()
                        || drone.stage() == RunDroneStage.SILENT
                        || drone.stage() == RunDroneStage.SUSPENDED
                        || drone.stage() == RunDroneStage.RESUMING)
                .map(RunDrone::id)
                .toList();
        for (RunWaypoint target : draft.targets()) {
            boolean refused = target.state() == RunWaypoint.State.WAITING
                    && !target.refusedBy().isEmpty()
                    && target.refusedBy().containsAll(left);
            if (refused) {
                draft.put(target.to(RunWaypoint.State.UNSERVED, null, Objects.requireNonNull(target.reason())));
            }
        }
    }

    /** Each needs something that all drones have but those that refused it. */
    static List<Waypoint> marked(RunTransition draft, List<Waypoint> open) {
        return open.stream()
                .map(waypoint -> draft.target(waypoint.id()).refusedBy().isEmpty() ? waypoint : needing(waypoint))
                .toList();
    }

    private static Waypoint needing(Waypoint waypoint) {
        Task task = waypoint.task();
        Set<Skill> needs = new HashSet<>(task.needs());
        needs.add(skill(waypoint.id()));
        return new Waypoint(
                waypoint.id(),
                waypoint.place(),
                new Task(task.serviceSeconds(), needs, task.parts()),
                waypoint.priority(),
                waypoint.window());
    }

    static List<Craft> marked(RunTransition draft, List<Craft> crafts, List<Waypoint> open) {
        List<Craft> marked = new ArrayList<>();
        for (Craft craft : crafts) {
            Set<Skill> skills = new HashSet<>(craft.skills());
            open.stream()
                    .map(waypoint -> draft.target(waypoint.id()))
                    .filter(target ->
                            !target.refusedBy().isEmpty() && !target.refusedBy().contains(craft.id()))
                    .forEach(target -> skills.add(skill(target.id())));
            marked.add(craft.withSkills(skills));
        }
        return marked;
    }

    private static Skill skill(String waypoint) {
        return new Skill("do what is to be done at the waypoint " + waypoint);
    }
}
