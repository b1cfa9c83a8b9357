package org.dronemap.cognitive.operation.recovery;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;

/** Plans how drones that stand in the air come home, or down, without coming near each other. Pure. */
public final class RecoveryPlanner {
    /** Two that come down nearer to each other than this would touch. */
    static final double GROUND_METERS = 4;

    private RecoveryPlanner() {}

    public static RecoveryPlan plan(RecoveryOrder order, List<RecoveryDrone> drones) {
        if (drones.isEmpty()) {
            return RecoveryPlan.refused(0, "No drone of it is in the air.");
        }
        Optional<String> onGround = tooNearOnTheGround(order, drones);
        if (onGround.isPresent()) {
            return RecoveryPlan.refused(drones.size(), onGround.get());
        }
        LocalPlane plane = new LocalPlane(drones.get(0).place());
        if (order.manner() == RecoveryManner.LAND) {
            return scheduled(
                    order,
                    drones.stream()
                            .map(drone -> RecoveryRoute.down(drone, plane))
                            .toList());
        }
        RecoveryLayers layers = new RecoveryLayers(order, drones, plane);
        if (layers.fitting() < drones.size()) {
            return RecoveryPlan.refused(layers.fitting(), tooMany(order, drones.size(), layers.fitting()));
        }
        Map<DroneId, Double> heights = layers.heights();
        return scheduled(
                order,
                drones.stream()
                        .map(drone -> RecoveryRoute.home(
                                drone, plane, heights.getOrDefault(drone.drone(), drone.amslMeters())))
                        .toList());
    }

    private static String tooMany(RecoveryOrder order, int all, int fitting) {
        return String.format(
                Locale.ROOT,
                "%d of %d drones fit between %.0f m and the ceiling of %.0f m above their homes, %.1f m above each other,"
                        + " and 10 m more where their homes are not known to be level. Choose fewer drones, or a higher"
                        + " ceiling.",
                fitting,
                all,
                order.lowestMeters(),
                order.ceilingMeters(),
                order.apart().verticalMeters());
    }

    private static Optional<String> tooNearOnTheGround(RecoveryOrder order, List<RecoveryDrone> drones) {
        for (int i = 0; i < drones.size(); i++) {
            for (RecoveryDrone other : drones.subList(i + 1, drones.size())) {
                RecoveryDrone one = drones.get(i);
                double meters = Geodesy.distanceMeters(comesDown(order, one), comesDown(order, other));
                if (meters < GROUND_METERS) {
                    return Optional.of(String.format(
                            Locale.ROOT,
                            "%s and %s would come down %.1f m from each other; at least %.0f m are kept. %s",
                            one.name(),
                            other.name(),
                            meters,
                            GROUND_METERS,
                            order.manner() == RecoveryManner.LAND
                                    ? "Move one of them first, or leave it out."
                                    : "Set another home for one of them, or leave it out."));
                }
            }
        }
        return Optional.empty();
    }

    private static Geodetic comesDown(RecoveryOrder order, RecoveryDrone drone) {
        return order.manner() == RecoveryManner.LAND
                ? drone.place()
                : drone.home().point();
    }

    private static RecoveryPlan scheduled(RecoveryOrder order, List<RecoveryRoute> routes) {
        RecoverySchedule schedule = new RecoverySchedule(order, routes);
        Optional<RecoverySchedule.Blocked> blocked = schedule.blocked();
        if (blocked.isPresent()) {
            return RecoveryPlan.refused(
                    routes.size(),
                    blocked.get().one().drone().name() + " cannot come down without coming near "
                            + blocked.get().other().drone().name() + ". Move one of them first, or leave it out.");
        }
        Map<DroneId, List<RecoveryWait>> waits = schedule.waits();
        Map<DroneId, Map<RecoveryStep, Double>> times = schedule.times(waits);
        List<RecoverySlot> slots = new ArrayList<>();
        for (RecoveryRoute route : routes) {
            DroneId id = route.drone().drone();
            Map<RecoveryStep, Double> own = times.getOrDefault(id, Map.of());
            RecoveryStep first =
                    order.manner() == RecoveryManner.LAND ? RecoveryStep.DESCENDING : RecoveryStep.LEVELLING;
            slots.add(new RecoverySlot(
                    id,
                    route.drone().place(),
                    route.layerAboveHome(),
                    comesDown(order, route.drone()),
                    waits.getOrDefault(id, List.of()),
                    own.getOrDefault(first, 0.0),
                    own.getOrDefault(RecoveryStep.DOWN, 0.0)));
        }
        slots.sort(Comparator.comparingDouble(RecoverySlot::downSeconds)
                .thenComparing(slot -> slot.drone().value()));
        return new RecoveryPlan(slots, routes.size(), null);
    }
}
