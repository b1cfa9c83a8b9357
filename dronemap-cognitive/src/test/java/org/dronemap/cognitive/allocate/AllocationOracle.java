package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.dronemap.cognitive.cost.AllocationDrone;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.dronemap.cognitive.cost.AllocationWaypoint;

/** Says of orders whether they can be flown and what they are worth, by arithmetic of its own. */
final class AllocationOracle {
    private static final double ROUNDING = 1e-6;

    private final AllocationProblem instance;

    AllocationOracle(AllocationProblem instance) {
        this.instance = instance;
    }

    /** What a plan is good for: first little left out, then few idle drones where all shall fly, then the aim. */
    record Expectation(double leftOut, int idle, double aim, double longest) {
        boolean isWorseThan(Expectation other) {
            if (leftOut != other.leftOut) {
                return leftOut > other.leftOut;
            }
            if (idle != other.idle) {
                return idle > other.idle;
            }
            return aim > other.aim + ROUNDING * Math.max(1, other.aim);
        }
    }

    /** What is wrong with the orders, as sentences. */
    List<String> faults(int[][] orders) {
        List<String> faults = new ArrayList<>();
        BitSet seen = new BitSet();
        for (int r = 0; r < orders.length; r++) {
            for (int waypoint : orders[r]) {
                if (seen.get(waypoint)) {
                    faults.add("waypoint " + waypoint + " is served twice");
                }
                seen.set(waypoint);
                if (!instance.visits().get(waypoint).drones().get(r)) {
                    faults.add("drone " + r + " cannot serve waypoint " + waypoint);
                }
            }
            if (Double.isNaN(fly(r, orders[r])[0])) {
                faults.add("drone " + r + " is late, or its battery is empty");
            }
        }
        return faults;
    }

    Expectation verdict(int[][] orders) {
        AllocationObjective aim = instance.aim();
        double longest = 0;
        double sum = 0;
        int idle = 0;
        double leftOut = instance.visits().stream()
                .mapToDouble(AllocationWaypoint::priority)
                .sum();
        for (int r = 0; r < orders.length; r++) {
            double[] flown = fly(r, orders[r]);
            if (orders[r].length > 0 || instance.carriers().get(r).mustFly()) {
                longest = Math.max(longest, flown[0]);
                sum += flown[1];
            }
            idle += orders[r].length == 0 && aim.everyDrone() ? 1 : 0;
            for (int waypoint : orders[r]) {
                leftOut -= instance.visits().get(waypoint).priority();
            }
        }
        return new Expectation(leftOut, idle, aim.longestWeight() * longest + aim.sumWeight() * sum, longest);
    }

    /** When the tour ends and what it adds to the sum; not a number when it cannot be flown. */
    double[] fly(int r, int[] order) {
        AllocationDrone carrier = instance.carriers().get(r);
        double clock = carrier.readySeconds();
        double meters = 0;
        double joules = 0;
        boolean late = false;
        int at = instance.start(r);
        for (int i = 0; i <= order.length; i++) {
            int to = i < order.length ? order[i] : instance.end(r);
            clock += instance.legs().seconds(carrier.type(), at, to);
            meters += instance.legs().meters(carrier.type(), at, to);
            joules += instance.legs().joules(carrier.type(), at, to);
            if (i < order.length) {
                AllocationWaypoint visit = instance.visits().get(to);
                double waits = Math.max(0, visit.opensSeconds() - clock);
                late |= clock + waits > visit.closesSeconds() + ROUNDING;
                clock += waits + visit.serviceSeconds();
                joules += (waits + visit.serviceSeconds()) * visit.serviceWatts();
            }
            at = to;
        }
        if (order.length > 0 && (late || joules > carrier.rangeJoules() * (1 + ROUNDING))) {
            return new double[] {Double.NaN, Double.NaN};
        }
        double sum = switch (instance.aim().measure()) {
            case SECONDS -> clock - carrier.readySeconds();
            case METERS -> meters;
            case JOULES -> joules;
        };
        return new double[] {clock, sum};
    }
}
