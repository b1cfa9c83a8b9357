package org.dronemap.core.separation;

import java.util.List;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;

/**
 * Changes the velocity of a following drone so that it keeps apart from the other drones in the air. The nearer it is,
 * the slower it may come closer; past each other both keep right, and it leaves the way of who gives way to nobody.
 * Immutable.
 */
public final class TrafficAvoidance {
    public static final TrafficAvoidance NONE = new TrafficAvoidance(List.of(), 0, 0);

    /** How hard it counts on braking, m/s². */
    private static final double BRAKING = 0.5;

    private static final double GIVING_WAY = 1;
    private static final double FASTEST_AWAY = 6;
    /** Who is led brakes by itself, unless it is very near. */
    private static final double FASTEST_FROM_LED = 2;

    private static final double NEAR_METERS = 4;
    /** It is out of the way of who gives way to nobody before that one is so near. */
    private static final double CLEAR_METERS = 20;

    private static final double FASTEST_ASIDE = 3;
    /** Of a speed as much each way. */
    private static final double DIAGONAL = Math.sqrt(0.5);

    /** From who comes straight on it goes to the right, seen from there. */
    private static final double UNDECIDED_METERS = 3;

    private static final double SLOWEST = 0.5;
    private static final double SOONEST_SECONDS = 1;
    /** Of what keeps it from going straight, so much goes to its right. */
    private static final double SIDEWAYS = 0.7;

    /** Within so much of what is kept on the way they evade each other upwards and downwards. */
    private static final double TOO_NEAR_METERS = 2;

    /** m/s that another one goes on with, and the share of what it has beyond. */
    private static final double RELIED_ON = 2;

    private static final double RELIED_ON_BEYOND = 0.4;
    private static final double SAME_HEIGHT_METERS = 0.5;
    private static final int ROUNDS = 8;
    private static final double FAR = 200;
    /** Kept in addition, half of it in height: receivers err, and what is heard of others is late. */
    private static final double WANDER_METERS = 4;

    private final List<Neighbor> neighbors;
    private final double horizontalMeters;
    private final double verticalMeters;

    /**
     * One of them.
     *
     * @param late seconds since it was there
     * @param led by one that keeps it apart from all others as well
     */
    public record ReportedDrone(DroneFix there, double late, boolean led) {}

    /** {@code was}: where it said that it is; {@code spot}: where it is by now if it goes on. */
    private record Neighbor(
            PlanePoint was, PlanePoint spot, double eastward, double northward, double amslMeters, boolean led) {
        double speed() {
            return Math.hypot(eastward, northward);
        }

        /** Metres from it along the way that it goes. */
        double ahead(PlanePoint there) {
            return (eastward * (there.eastMeters() - spot.eastMeters())
                            + northward * (there.northMeters() - spot.northMeters()))
                    / speed();
        }

        /** Metres to the right of the way that it goes. */
        double right(PlanePoint there) {
            return (northward * (there.eastMeters() - spot.eastMeters())
                            - eastward * (there.northMeters() - spot.northMeters()))
                    / speed();
        }
    }

    private TrafficAvoidance(List<Neighbor> neighbors, double horizontalMeters, double verticalMeters) {
        this.neighbors = List.copyOf(neighbors);
        this.horizontalMeters = horizontalMeters;
        this.verticalMeters = verticalMeters;
    }

    /** As they are by now. */
    public static TrafficAvoidance of(LocalPlane plane, List<ReportedDrone> all, Separation apart) {
        List<Neighbor> neighbors = all.stream()
                .map(heard -> {
                    DroneFix one = heard.there();
                    PlanePoint spot = plane.spot(one.point());
                    PlanePoint now = new PlanePoint(
                            spot.eastMeters() + one.eastward() * heard.late(),
                            spot.northMeters() + one.northward() * heard.late());
                    return new Neighbor(
                            spot, now, one.eastward(), one.northward(), one.altitudeAmslMeters(), heard.led());
                })
                .toList();
        return new TrafficAvoidance(
                neighbors, apart.horizontalMeters() + WANDER_METERS, apart.verticalMeters() + WANDER_METERS / 2);
    }

    /** The nearest to that speed by which it keeps apart, if it may be at any of these spots at that height. */
    public GroundVelocity allowed(List<PlanePoint> here, double amslMeters, GroundVelocity wanted) {
        GroundVelocity speed = wanted;
        for (int round = 0; round < ROUNDS; round++) {
            GroundVelocity before = speed;
            for (Neighbor one : neighbors) {
                if (Math.abs(one.amslMeters() - amslMeters) < verticalMeters) {
                    // All of it goes out of the way on one side.
                    boolean right = one.right(here.get(0)) > -UNDECIDED_METERS;
                    for (PlanePoint spot : here) {
                        speed = kept(one, spot, speed, round == 0, right);
                    }
                }
            }
            if (speed.equals(before)) {
                break;
            }
        }
        return speed;
    }

    private GroundVelocity kept(
            Neighbor other, PlanePoint here, GroundVelocity wanted, boolean sideways, boolean right) {
        // Who flies away may have stopped since.
        PlanePoint there = other.ahead(here) < 0 ? other.was() : other.spot();
        double meters = there.distanceMeters(here);
        if (meters > FAR) {
            return wanted;
        }
        // From the other to here; right above each other any way out is as good.
        double east = meters < 0.1 ? 1 : (here.eastMeters() - there.eastMeters()) / meters;
        double north = meters < 0.1 ? 0 : (here.northMeters() - there.northMeters()) / meters;
        double comes = other.eastward() * east + other.northward() * north;
        double closer = -(wanted.eastward() * east + wanted.northward() * north);
        double most = most(other, closing(meters), comes, closer);
        if (closer <= most) {
            return wanted;
        }
        if (!other.led() && most < 0 && comes > 0) {
            return sidestep(other, here, wanted, new GroundVelocity(east, north), -most, right);
        }
        double fastest = other.led() && meters > horizontalMeters + NEAR_METERS ? FASTEST_FROM_LED : FASTEST_AWAY;
        double less = closer - Math.max(-fastest, most);
        double turn = sideways ? SIDEWAYS * Math.min(less, Math.max(0, closer)) : 0;
        return new GroundVelocity(
                wanted.eastward() + east * less - north * turn, wanted.northward() + north * less + east * turn);
    }

    /**
     * Whoever flies ahead of one that is faster and gives way to nobody is driven along by it for ever. It leaves the other's way,
     * as fast as it has to be clear of it when it comes by; where it is late for that, away from it as well.
     *
     * @param away from the other to here, of length 1
     * @param excess m/s that it comes on beyond what it may
     */
    private GroundVelocity sidestep(
            Neighbor other, PlanePoint here, GroundVelocity wanted, GroundVelocity away, double excess, boolean right) {
        double side = right ? 1 : -1;
        GroundVelocity aside =
                new GroundVelocity(other.northward() / other.speed() * side, -other.eastward() / other.speed() * side);
        double along = (wanted.eastward() * other.eastward() + wanted.northward() * other.northward()) / other.speed();
        double seconds = (other.ahead(here) - CLEAR_METERS) / Math.max(other.speed() - along, SLOWEST);
        double least = (horizontalMeters - other.right(here) * side) / seconds;
        if (seconds >= SOONEST_SECONDS && least <= FASTEST_ASIDE) {
            return wanted.atLeast(least, aside);
        }
        double half = DIAGONAL * Math.min(FASTEST_AWAY, excess);
        return wanted.atLeast(Math.max(half, DIAGONAL * FASTEST_ASIDE), aside).atLeast(half, away);
    }

    /** Of a speed at which the other flies ahead: one that is fast may brake before that is heard of. */
    private static double lasting(double ahead) {
        return Math.min(ahead, RELIED_ON + (ahead - RELIED_ON) * RELIED_ON_BEYOND);
    }

    /**
     * How fast it may come closer itself, m/s; negative: so fast it flees.
     *
     * @param may how fast the two may come closer
     * @param comes how fast the other comes on
     * @param closer how fast it would come closer
     */
    private static double most(Neighbor other, double may, double comes, double closer) {
        if (comes <= 0) {
            return may + lasting(-comes);
        }
        if (comes <= may || !other.led()) {
            return may - comes;
        }
        // That one may come on by so much, and by what it is left: who flees from that is driven along.
        return Math.min(0, may + lasting(Math.max(0, -closer)) - comes);
    }

    /** How fast the two may come closer, m/s. */
    private double closing(double meters) {
        double room = meters - horizontalMeters;
        return room >= 0 ? Math.sqrt(2 * BRAKING * room) : room * GIVING_WAY;
    }

    /** Upwards or downwards as far as nobody is there; from who is too near all the same the higher one goes up, the other down. */
    public double level(PlanePoint here, double amslMeters, double wantedMeters) {
        double least = Double.NEGATIVE_INFINITY;
        double most = Double.POSITIVE_INFINITY;
        for (Neighbor one : neighbors) {
            double meters = one.spot().distanceMeters(here);
            double above = amslMeters - one.amslMeters();
            boolean evades = meters < horizontalMeters - TOO_NEAR_METERS && Math.abs(above) < verticalMeters;
            if (meters < horizontalMeters && isHigher(one, here, above)) {
                double over = one.amslMeters() + verticalMeters;
                least = Math.max(least, evades ? over : Math.min(amslMeters, over));
            } else if (meters < horizontalMeters) {
                double under = one.amslMeters() - verticalMeters;
                most = Math.min(most, evades ? under : Math.max(amslMeters, under));
            }
        }
        return Math.max(Math.min(wantedMeters, most), least);
    }

    /** At one height it is the more eastern one, so that both say the same. */
    private static boolean isHigher(Neighbor other, PlanePoint here, double above) {
        return Math.abs(above) < SAME_HEIGHT_METERS
                ? here.eastMeters() > other.spot().eastMeters()
                : above > 0;
    }
}
