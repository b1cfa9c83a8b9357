package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.plan.Stop;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.Unserved;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** A run that nothing has happened to yet. */
final class Beginning {
    private Beginning() {}

    static RunState of(RunOrder order) {
        return new RunState(
                order.id(),
                order.at(),
                Setting.of(order),
                targets(order),
                drones(order),
                RunState.Counts.NONE,
                null,
                List.of(),
                null,
                List.of(),
                false,
                null);
    }

    private static List<Target> targets(RunOrder order) {
        Map<String, DroneId> whose = new HashMap<>();
        order.plan().tours().forEach(tour -> tour.stops().forEach(stop -> whose.put(stop.waypoint(), tour.drone())));
        Map<String, String> why =
                order.plan().unserved().stream().collect(Collectors.toMap(Unserved::waypoint, Unserved::why));
        List<Target> targets = new ArrayList<>();
        for (Waypoint waypoint : order.problem().waypoints()) {
            Target waiting = Target.waiting(waypoint);
            DroneId drone = whose.get(waypoint.id());
            targets.add(
                    drone == null
                            ? waiting.to(Target.State.WAITING, null, why.get(waypoint.id()))
                            : waiting.to(Target.State.ASSIGNED, drone, null));
        }
        return targets;
    }

    private static List<RunDrone> drones(RunOrder order) {
        Map<DroneId, RunOrder.Member> members =
                order.members().stream().collect(Collectors.toMap(RunOrder.Member::drone, Function.identity()));
        Map<DroneId, Tour> tours =
                order.plan().tours().stream().collect(Collectors.toMap(Tour::drone, Function.identity()));
        List<RunDrone> drones = new ArrayList<>();
        for (Craft craft : order.problem().crafts()) {
            RunOrder.Member member = members.get(craft.id());
            if (member == null) {
                throw new IllegalArgumentException("the drone " + craft.id() + " is no member of the run");
            }
            drones.add(drone(order, craft, member, tours.get(craft.id())));
        }
        return drones;
    }

    private static RunDrone drone(RunOrder order, Craft craft, RunOrder.Member member, @Nullable Tour tour) {
        if (tour == null || tour.stops().isEmpty()) {
            return drone(order, craft, member, DroneStage.LANDED, null);
        }
        return drone(order, craft, member, DroneStage.UPLOADING, Sortie.of(craft, member.kind(), tour, order.at()));
    }

    private static RunDrone drone(
            RunOrder order, Craft craft, RunOrder.Member member, DroneStage stage, @Nullable Sortie sortie) {
        return new RunDrone(
                craft,
                member.name(),
                member.kind(),
                stage,
                order.at(),
                sortie == null
                        ? List.of()
                        : sortie.tour().stops().stream().map(Stop::waypoint).toList(),
                sortie,
                0,
                null,
                null,
                0,
                null,
                RunDrone.Signs.NONE);
    }
}
