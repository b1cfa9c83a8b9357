package org.dronemap.cognitive.operation.recovery;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;

/**
 * A plan of a recovery as it would be flown, each drone at speeds of its own, ten times a second: where each is, by nothing but
 * its slot, and how near two come.
 */
final class FlownPlan {
    private static final double STRIDE = 0.1;
    private static final double TOUCHED_DOWN = 0.3;

    private final RecoveryOrder order;
    private final List<Flyer> flyers = new ArrayList<>();
    private final Map<DroneId, Flyer> byId = new HashMap<>();
    private double least = Double.POSITIVE_INFINITY;
    private String where = "";
    private double seconds;

    private static final class Flyer {
        private final RecoveryDrone drone;
        private final RecoverySlot slot;
        private final PlanePoint home;
        private final double cruise;
        private final double climb;
        private double east;
        private double north;
        private double height;
        private double pause;
        private RecoveryStep step = RecoveryStep.ALOFT;

        Flyer(RecoveryDrone drone, RecoverySlot slot, LocalPlane plane, Random chance) {
            this.drone = drone;
            this.slot = slot;
            PlanePoint here = plane.spot(drone.place());
            PlanePoint there = plane.spot(slot.comesDown());
            this.home = there;
            this.cruise = 1 + 9 * chance.nextDouble();
            this.climb = 0.5 + 3 * chance.nextDouble();
            this.east = here.eastMeters();
            this.north = here.northMeters();
            this.height = drone.heightMeters();
            this.pause = 10 * chance.nextDouble();
        }

        double amsl() {
            return drone.home().altitudeAmslMeters() + height;
        }

        private boolean rises(double wanted) {
            double left = wanted - height;
            height += Math.signum(left) * Math.min(Math.abs(left), climb * STRIDE);
            return Math.abs(wanted - height) < 1e-9;
        }

        private boolean goes() {
            double e = home.eastMeters() - east;
            double n = home.northMeters() - north;
            double left = Math.hypot(e, n);
            double share = left < 1e-9 ? 0 : Math.min(1, cruise * STRIDE / left);
            east += share * e;
            north += share * n;
            return left <= cruise * STRIDE;
        }

        /** It has done its move. */
        boolean moves() {
            return switch (step) {
                case LEVELLING -> rises(slot.layerMeters());
                case UNDER_WAY -> goes();
                case DESCENDING -> rises(0) || height < TOUCHED_DOWN;
                case ALOFT, LEVEL, OVER_HOME, DOWN -> false;
            };
        }
    }

    FlownPlan(RecoveryOrder order, List<RecoveryDrone> drones, RecoveryPlan plan, Random chance) {
        this.order = order;
        LocalPlane plane = new LocalPlane(drones.get(0).place());
        for (RecoveryDrone drone : drones) {
            RecoverySlot slot = plan.slots().stream()
                    .filter(one -> one.drone().equals(drone.drone()))
                    .findFirst()
                    .orElseThrow();
            Flyer flyer = new Flyer(drone, slot, plane, chance);
            flyers.add(flyer);
            byId.put(drone.drone(), flyer);
        }
    }

    /** Whether all are down within that time. */
    boolean fly(double longestSeconds) {
        for (seconds = 0; seconds < longestSeconds; seconds += STRIDE) {
            flyers.forEach(this::advance);
            look();
            if (flyers.stream().allMatch(flyer -> flyer.step == RecoveryStep.DOWN)) {
                return true;
            }
        }
        return false;
    }

    private void advance(Flyer flyer) {
        if (flyer.step == RecoveryStep.DOWN) {
            return;
        }
        if (flyer.step.isMove()) {
            if (flyer.moves()) {
                flyer.step = flyer.step.next();
            }
            return;
        }
        flyer.pause -= STRIDE;
        boolean free = flyer.slot.waits().stream()
                .filter(wait -> wait.step() == flyer.step.next())
                .allMatch(wait -> !byId.get(wait.other()).step.isBefore(wait.reached()));
        if (free && flyer.pause <= 0) {
            flyer.step = flyer.step.next();
        }
    }

    private void look() {
        for (int i = 0; i < flyers.size(); i++) {
            for (Flyer other : flyers.subList(i + 1, flyers.size())) {
                look(flyers.get(i), other);
            }
        }
    }

    private void look(Flyer one, Flyer other) {
        if (one.step == RecoveryStep.DOWN || other.step == RecoveryStep.DOWN) {
            return;
        }
        double beside = Math.hypot(one.east - other.east, one.north - other.north);
        double above = Math.abs(one.amsl() - other.amsl());
        double share = Math.max(
                beside / order.apart().horizontalMeters(), above / order.apart().verticalMeters());
        if (share < least) {
            least = share;
            where = one.drone.name() + " " + one.step + " and " + other.drone.name() + " " + other.step + ", " + beside
                    + " m beside, " + above + " m above, after " + seconds + " s";
        }
    }

    double least() {
        return least;
    }

    double seconds() {
        return seconds;
    }

    String where() {
        return where;
    }
}
