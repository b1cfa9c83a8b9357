package org.dronemap.cognitive.operation.recovery;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.separation.VerticalMargin;

/**
 * Assigns a height above the sea to each drone, so that ways home that come near each other are far enough above each other.
 * Whoever stands higher flies home higher: nobody has to climb or descend through another one.
 */
final class RecoveryLayers {
    private final RecoveryOrder order;
    private final LocalPlane plane;
    private final List<RecoveryDrone> byHeight;
    private final Map<DroneId, Double> lowest = new HashMap<>();
    private final List<RecoveryDrone> fitting = new ArrayList<>();

    RecoveryLayers(RecoveryOrder order, List<RecoveryDrone> drones, LocalPlane plane) {
        this.order = order;
        this.plane = plane;
        this.byHeight = drones.stream()
                .sorted(Comparator.comparingDouble(RecoveryDrone::amslMeters)
                        .thenComparing(drone -> drone.drone().value()))
                .toList();
        for (RecoveryDrone drone : byHeight) {
            double height = lowestFor(drone);
            if (height <= ceiling(drone)) {
                lowest.put(drone.drone(), height);
                fitting.add(drone);
            }
        }
    }

    /** How many find room. */
    int fitting() {
        return fitting.size();
    }

    private double lowestFor(RecoveryDrone drone) {
        double height = floor(drone);
        for (RecoveryDrone other : fitting) {
            if (areNear(drone, other)) {
                height = Math.max(height, lowest.getOrDefault(other.drone(), 0.0) + apart(drone, other));
            }
        }
        return height;
    }

    /** Each as near to its present height as the others let it. */
    Map<DroneId, Double> heights() {
        Map<DroneId, Double> heights = new HashMap<>();
        List<RecoveryDrone> downwards = new ArrayList<>(fitting);
        Collections.reverse(downwards);
        for (RecoveryDrone drone : downwards) {
            double height =
                    Math.min(ceiling(drone), Math.max(lowest.getOrDefault(drone.drone(), 0.0), drone.amslMeters()));
            for (RecoveryDrone higher : fitting) {
                Double above = heights.get(higher.drone());
                if (above != null && areNear(drone, higher)) {
                    height = Math.min(height, above - apart(drone, higher));
                }
            }
            heights.put(drone.drone(), height);
        }
        return heights;
    }

    private double floor(RecoveryDrone drone) {
        double usual = drone.home().altitudeAmslMeters() + order.lowestMeters();
        return drone.isOverHome() ? Math.min(usual, drone.amslMeters()) : usual;
    }

    private double ceiling(RecoveryDrone drone) {
        double usual = drone.home().altitudeAmslMeters() + drone.highestMeters();
        return drone.isOverHome() ? Math.max(usual, drone.amslMeters()) : usual;
    }

    private boolean areNear(RecoveryDrone one, RecoveryDrone other) {
        return way(one).distanceMeters(way(other)) < order.apart().horizontalMeters();
    }

    private PlaneSegment way(RecoveryDrone drone) {
        return new PlaneSegment(
                plane.spot(drone.place()), plane.spot(drone.home().point()));
    }

    private double apart(RecoveryDrone one, RecoveryDrone other) {
        return order.apart().verticalMeters() + VerticalMargin.between(one.home(), other.home());
    }
}
