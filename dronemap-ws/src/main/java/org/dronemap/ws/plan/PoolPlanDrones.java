package org.dronemap.ws.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.operation.DronePool;
import org.dronemap.ws.operation.PoolDroneSelector;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;

/** Chooses the drones of the pool for a plan: those that are free and can fly missions, the nearest ones. Any thread. */
public final class PoolPlanDrones {
    private final PoolDroneSelector drones;
    private final DronePool pool;

    public PoolPlanDrones(CloudManager cloud, DronePool pool) {
        this.drones = new PoolDroneSelector(cloud);
        this.pool = pool;
    }

    /**
     * The drones that were found.
     *
     * @param chosen the nearest first
     * @param why each of the others cannot be planned with, as sentences
     */
    public record Found(List<DroneState> chosen, String why) {
        public Found {
            chosen = List.copyOf(chosen);
        }
    }

    /** Up to so many, but none of {@code others}; nearest to any of those places. */
    public Found find(Principal principal, int upTo, List<Geodetic> places, Set<DroneId> others) {
        List<DroneState> fit = new ArrayList<>();
        List<String> why = new ArrayList<>();
        Set<DroneId> waiting = pool.drones();
        for (DroneState drone : drones.commandable(principal)) {
            if (!waiting.contains(drone.id()) || others.contains(drone.id())) {
                continue;
            }
            String objection = objection(drone);
            if (objection == null) {
                fit.add(drone);
            } else {
                why.add(objection);
            }
        }
        List<DroneState> nearest = fit.stream()
                .sorted(Comparator.comparingDouble((DroneState drone) -> meters(drone, places))
                        .thenComparing(drone -> drone.id().value()))
                .limit(upTo)
                .toList();
        return new Found(nearest, why.isEmpty() ? "The pool has no other drone for you." : String.join(" ", why));
    }

    /** Nobody has control of it. */
    public boolean isFree(DroneId drone) {
        return drones.isFree(drone);
    }

    private @Nullable String objection(DroneState drone) {
        if (!drones.isFree(drone.id())) {
            return "“" + drone.name() + "” is not free.";
        }
        if (Boolean.FALSE.equals(drone.readyToArm())) {
            return "“" + drone.name() + "”: its own checks do not let it arm.";
        }
        try {
            Objects.requireNonNull(PlanDroneFactory.of(drone));
            return null;
        } catch (Rejection unfit) {
            return unfit.sentence();
        }
    }

    private static double meters(DroneState drone, List<Geodetic> places) {
        Stream<Geodetic> stand = Stream.ofNullable(drone.position()).flatMap(at -> Stream.ofNullable(at.point()));
        Home home = drone.home();
        Geodetic from = stand.findFirst().orElse(home == null ? null : home.point());
        return from == null
                ? Double.POSITIVE_INFINITY
                : places.stream()
                        .mapToDouble(place -> Geodesy.distanceMeters(from, place))
                        .min()
                        .orElse(0);
    }
}
