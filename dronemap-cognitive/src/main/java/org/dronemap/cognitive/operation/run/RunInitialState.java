package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunSettings;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.plan.UnservedWaypoint;
import org.dronemap.cognitive.plan.WaysHome;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;

/** Creates the initial state of a mission run from its order. */
final class RunInitialState {
    private RunInitialState() {}

    static RunState of(RunOrder order) {
        List<RunDrone> drones = drones(order);
        return new RunState(
                order.id(),
                new RunState.Clock(order.at(), false, null, null, null),
                RunSettings.of(order),
                targets(order),
                drones,
                new RunState.Counts(0, 0, drones.size(), 0, 0, 0, 0, 0),
                null,
                List.of(),
                null,
                List.of(),
                false,
                null,
                RunState.WORDING);
    }

    private static List<RunWaypoint> targets(RunOrder order) {
        Map<String, DroneId> whose = new HashMap<>();
        order.plan().tours().forEach(tour -> tour.stops().forEach(stop -> whose.put(stop.waypoint(), tour.drone())));
        Map<String, String> why = order.plan().unserved().stream()
                .collect(Collectors.toMap(UnservedWaypoint::waypoint, UnservedWaypoint::why));
        List<RunWaypoint> targets = new ArrayList<>();
        for (Waypoint waypoint : order.problem().waypoints()) {
            RunWaypoint waiting = RunWaypoint.waiting(waypoint);
            DroneId drone = whose.get(waypoint.id());
            targets.add(
                    drone == null
                            ? waiting.leftOut(why.get(waypoint.id()))
                            : waiting.to(RunWaypoint.State.ASSIGNED, drone, null));
        }
        return targets;
    }

    private static List<RunDrone> drones(RunOrder order) {
        Map<DroneId, RunOrder.Member> members =
                order.members().stream().collect(Collectors.toMap(RunOrder.Member::drone, Function.identity()));
        Map<DroneId, Tour> tours =
                order.plan().tours().stream().collect(Collectors.toMap(Tour::drone, Function.identity()));
        Map<String, Task> tasks =
                order.problem().waypoints().stream().collect(Collectors.toMap(Waypoint::id, Waypoint::task));
        WaysHome ways = WaysHome.of(
                order.problem(),
                order.plan(),
                drone -> members.containsKey(drone) && members.get(drone).kind().isRotorcraft());
        ReturnLayers others = ReturnLayers.of(order.problem(), order.plan());
        int above = order.plan().tours().size();
        List<RunDrone> drones = new ArrayList<>();
        for (Craft craft : order.problem().crafts()) {
            RunOrder.Member member = members.get(craft.id());
            if (member == null) {
                throw new IllegalArgumentException("the drone " + craft.id() + " is no member of the run");
            }
            Double own = ways.height(craft.id()).orElse(null);
            Double height = own == null ? others.of(craft, member.kind(), above++) : own;
            RunDrone joining =
                    RunDrone.joining(new RunDrone.Profile(craft, member.name(), member.kind(), height), order.at());
            Tour tour = tours.get(craft.id());
            drones.add(
                    tour == null || tour.stops().isEmpty()
                            ? joining
                            : flying(joining, tour, drones.size() + 1, tasks::get));
        }
        return drones;
    }

    private static RunDrone flying(RunDrone drone, Tour tour, int number, Function<String, Task> tasks) {
        return drone.withNext(Sortie.of(number, drone.profile(), tour, drone.since(), tasks))
                .withOrders(tour.stops().stream().map(TourStop::waypoint).toList())
                .to(RunDroneStage.UPLOADING, drone.since());
    }
}
