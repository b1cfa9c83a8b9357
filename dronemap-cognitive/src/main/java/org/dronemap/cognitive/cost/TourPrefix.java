package org.dronemap.cognitive.cost;

import java.util.Arrays;

/**
 * Works out the firm beginning of one drone's tour: where, when and with what energy drawn it ends. Used once, by one
 * thread.
 */
final class TourPrefix {
    private static final double ROUNDING = 1e-9;

    private final AllocationProblem instance;
    private final int drone;
    private final AllocationDrone carrier;
    private final int[] order;
    private int place;
    private double seconds;
    private double meters;
    private double joules;
    private int count;

    TourPrefix(AllocationProblem instance, int drone, int[] firm) {
        this.instance = instance;
        this.drone = drone;
        carrier = instance.carriers().get(drone);
        place = instance.start(drone);
        seconds = carrier.readySeconds();
        while (count < firm.length && goesOnTo(firm[count])) {
            count++;
        }
        order = Arrays.copyOf(firm, count);
    }

    /** Stays where it is when it cannot serve that, or not come to its end from there. */
    private boolean goesOnTo(int waypoint) {
        Legs legs = instance.legs();
        AllocationWaypoint visit = instance.visits().get(waypoint);
        double arrives = seconds + legs.seconds(carrier.type(), place, waypoint);
        double begins = Math.max(arrives, visit.opensSeconds());
        double leaves = begins + visit.serviceSeconds();
        double drawn =
                joules + legs.joules(carrier.type(), place, waypoint) + (leaves - arrives) * visit.serviceWatts();
        double atEnd = drawn + legs.joules(carrier.type(), waypoint, instance.end(drone));
        boolean can = visit.drones().get(drone)
                && Double.isFinite(leaves + legs.seconds(carrier.type(), waypoint, instance.end(drone)))
                && begins <= visit.closesSeconds()
                && atEnd <= carrier.rangeJoules() * (1 + ROUNDING);
        if (can) {
            meters += legs.meters(carrier.type(), place, waypoint);
            seconds = leaves;
            joules = drawn;
            place = waypoint;
        }
        return can;
    }

    int[] order() {
        return order.clone();
    }

    /** Where it ends. */
    int place() {
        return place;
    }

    /** What the aim sums. */
    double sum() {
        return switch (instance.aim().measure()) {
            case SECONDS -> seconds - carrier.readySeconds();
            case METERS -> meters;
            case JOULES -> joules;
        };
    }

    /** The drone as it is then. */
    AllocationDrone carrier() {
        return count == 0
                ? carrier
                : new AllocationDrone(carrier.type(), seconds, Math.max(0, carrier.rangeJoules() - joules), true, true);
    }
}
