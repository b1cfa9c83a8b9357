package org.dronemap.cognitive.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.GroundVelocity;
import org.dronemap.core.separation.TrafficAvoidance;
import org.jspecify.annotations.Nullable;

/**
 * Guides one drone to its place beside a target: computes setpoints that keep to limits, zones and other traffic. A
 * carrot runs ahead of the drone as the drone itself could fly: it begins where the drone is, keeps to speeds and
 * fences, and comes up to where the drone has to be when it hears of it; the drone is told to be where the carrot is,
 * and to move with it. Owned by one thread.
 */
public final class StandOffGuidance {
    /** So long after the newest fix came the drone goes on; then it holds. */
    public static final Duration PATIENCE = Duration.ofSeconds(2);
    /** Whoever hears nothing more goes on as it was told for so long, */
    private static final double DEAF_SECONDS = 3;
    /** and only then begins to brake: a real ArduCopter needs 6.7 m from 5 m/s. */
    private static final double DEAF_BRAKING = 1.8;

    private static final double ACCELERATION = 2.3;
    private static final double BRAKING = 1.3;

    /**
     * An ArduCopter turns by as much as it is off what it is told (2 m/s² for each m/s), and heeds no acceleration beside a
     * place: so it is told how it shall move so much later.
     */
    private static final double TURNING_SECONDS = 0.5;

    private static final double GAIN = 1.2;
    private static final double CLIMB = 2;
    private static final double SINK = 1.2;
    private static final double LOW_METERS = 1;
    /** It is led no nearer to the lowest height: in wind copters hold theirs within some tenths. */
    private static final double FLOOR_METERS = 0.5;

    private static final double LONGEST_STEP = 1;
    private static final double NANOS = 1e9;

    private final LocalPlane plane;
    private final StandOffPosition stance;
    private @Nullable ReferencePoint carrot;
    private @Nullable Instant before;
    private double heading;
    /** It has been as high as it has to be. */
    private boolean risen;

    /** One guidance cycle: the time that passes, and the limits for it. */
    private record Cycle(double seconds, GuidanceLimits limits, double speed, Environment around, PlanePoint drone) {
        /** Who rises goes nowhere but up, among trees as it may be: all others keep away from it. */
        Cycle alone() {
            return new Cycle(seconds, limits, speed, new Environment(around.room(), TrafficAvoidance.NONE), drone);
        }
    }

    /** The flyable area and the other drones to keep away from. */
    public record Environment(FlyableArea room, TrafficAvoidance others) {}

    /** The reference point that the drone follows: position in metres of the plane, velocity in m/s. */
    private record ReferencePoint(PlanePoint spot, double eastward, double northward, double up, double upward) {}

    /** {@code target}: whoever is followed; its filter may be told of fixes meanwhile. */
    public StandOffGuidance(TrackedTarget target) {
        plane = target.plane();
        stance = new StandOffPosition(target);
    }

    /** Begins anew from where the drone is, as when somebody else flew it meanwhile. */
    public void reset() {
        carrot = null;
        before = null;
        risen = false;
    }

    /**
     * Where the drone shall be.
     *
     * @param heard when the newest fix of the target came; null: none did
     */
    public GuidanceSetpoint guide(
            Instant now,
            StandOff standOff,
            GuidanceLimits limits,
            Environment around,
            DroneFix drone,
            @Nullable Instant heard) {
        double seconds = before == null ? 0 : Math.min(LONGEST_STEP, seconds(before, now));
        before = now;
        Instant there = now.plusNanos((long) (limits.downlinkSeconds() * NANOS));
        PlanePoint expected = expected(drone, there);
        ReferencePoint loose = carrot == null ? begun(drone) : carrot;
        FollowPointLimit leash = referenceLimit(loose, drone, there);
        ReferencePoint from = limited(loose, leash, expected);
        StandOffPosition.Wanted wanted = stance.at(there, standOff, seconds);
        Cycle step = new Cycle(seconds, limits, Math.min(limits.speed(), leash.speed()), around, expected);
        FlyableArea room = around.room();
        boolean low = isLow(drone.altitudeAmslMeters(), limits);
        ReferencePoint next;
        GuidanceSetpoint.Phase doing;
        if (wanted == null || heard == null || Duration.between(heard, now).compareTo(PATIENCE) > 0) {
            doing = GuidanceSetpoint.Phase.HOLDING;
            next = moved(from, 0, 0, low ? step.alone() : step);
        } else if (low) {
            doing = GuidanceSetpoint.Phase.CLIMBING;
            next = moved(from, 0, 0, step.alone());
        } else {
            PlanePoint free = room.nearest(wanted.spot());
            double share = room.clearShare(from.spot(), free);
            boolean fenced = share < 1 || free.distanceMeters(wanted.spot()) > LOW_METERS;
            doing = fenced ? GuidanceSetpoint.Phase.FENCED : GuidanceSetpoint.Phase.FOLLOWING;
            next = chase(from, wanted, at(from.spot(), free, share), fenced, step);
        }
        next = levelled(next, standOff, step);
        carrot = next;
        updateHeading(wanted, next);
        return aim(next, commandedVelocity(from, next, step), doing);
    }

    /** Turned on by what it turns meanwhile, slowed by half of what it brakes, and no faster. */
    private static GroundVelocity commandedVelocity(ReferencePoint from, ReferencePoint next, Cycle step) {
        double speed = Math.hypot(next.eastward(), next.northward());
        if (step.seconds() == 0 || speed == 0) {
            return new GroundVelocity(next.eastward(), next.northward());
        }
        double share = TURNING_SECONDS / step.seconds();
        double slower = Math.max(0, Math.hypot(from.eastward(), from.northward()) - speed) * share / 2;
        double aside = next.eastward() * from.northward() - next.northward() * from.eastward();
        double turned = aside / speed * share;
        double size = Math.max(0, speed - slower) / Math.hypot(speed, turned);
        double across = turned / speed * size;
        double east = next.eastward() * size + next.northward() * across;
        double north = next.northward() * size - next.eastward() * across;
        GroundVelocity apart = step.around()
                .others()
                .allowed(List.of(next.spot(), step.drone()), next.up(), new GroundVelocity(east, north));
        double free = brakingShare(step.around().room(), next.spot(), apart.eastward(), apart.northward());
        return new GroundVelocity(apart.eastward() * free, apart.northward() * free);
    }

    /** A gust that presses it down a little does not hold it up once it has risen. */
    private boolean isLow(double amslMeters, GuidanceLimits limits) {
        risen |= amslMeters >= limits.lowestAmslMeters();
        return amslMeters < limits.lowestAmslMeters() - (risen ? LOW_METERS : 0);
    }

    private GuidanceSetpoint aim(ReferencePoint next, GroundVelocity told, GuidanceSetpoint.Phase doing) {
        return new GuidanceSetpoint(
                plane.place(next.spot()), next.up(), told.eastward(), told.northward(), next.upward(), heading, doing);
    }

    private ReferencePoint begun(DroneFix drone) {
        return new ReferencePoint(
                plane.spot(drone.point()), drone.eastward(), drone.northward(), drone.altitudeAmslMeters(), 0);
    }

    private FollowPointLimit referenceLimit(ReferencePoint from, DroneFix drone, Instant there) {
        return FollowPointLimit.of(
                expected(drone, there).distanceMeters(from.spot()),
                Math.hypot(drone.eastward(), drone.northward()),
                late(drone, there));
    }

    /** The drone may be blown away, or be slower than it should: then the carrot waits for it. */
    private static ReferencePoint limited(ReferencePoint from, FollowPointLimit leash, PlanePoint expected) {
        double apart = expected.distanceMeters(from.spot());
        double speed = Math.hypot(from.eastward(), from.northward());
        double slower = speed > leash.speed() ? leash.speed() / speed : 1;
        return new ReferencePoint(
                apart <= leash.meters() ? from.spot() : at(expected, from.spot(), leash.meters() / apart),
                from.eastward() * slower,
                from.northward() * slower,
                from.up(),
                from.upward());
    }

    private PlanePoint expected(DroneFix drone, Instant there) {
        double late = late(drone, there);
        PlanePoint last = plane.spot(drone.point());
        return new PlanePoint(
                last.eastMeters() + drone.eastward() * late, last.northMeters() + drone.northward() * late);
    }

    private static double late(DroneFix drone, Instant there) {
        return Math.max(0, Math.min(2, seconds(drone.at(), there)));
    }

    private static PlanePoint at(PlanePoint from, PlanePoint to, double share) {
        return new PlanePoint(
                from.eastMeters() + (to.eastMeters() - from.eastMeters()) * share,
                from.northMeters() + (to.northMeters() - from.northMeters()) * share);
    }

    private static ReferencePoint chase(
            ReferencePoint from, StandOffPosition.Wanted wanted, PlanePoint to, boolean fenced, Cycle step) {
        double share = fenced ? 0 : 1;
        // Where it comes by going along with the target: the rest is to be made up.
        double east = to.eastMeters() - from.spot().eastMeters() - wanted.eastward() * share * step.seconds();
        double north = to.northMeters() - from.spot().northMeters() - wanted.northward() * share * step.seconds();
        double apart = Math.hypot(east, north);
        double closing = apart == 0 ? 0 : approach(apart) / apart;
        return moved(
                from, wanted.eastward() * share + east * closing, wanted.northward() * share + north * closing, step);
    }

    /** The speed from which it still stops in time. */
    private static double approach(double meters) {
        double linear = BRAKING / (GAIN * GAIN);
        return meters <= linear ? meters * GAIN : Math.sqrt(2 * BRAKING * (meters - linear / 2));
    }

    /** Towards these speeds, as fast as may be. */
    private static ReferencePoint moved(ReferencePoint from, double eastward, double northward, Cycle step) {
        double faster = Math.max(1, Math.hypot(eastward, northward) / step.speed());
        double moreEast = eastward / faster - from.eastward();
        double moreNorth = northward / faster - from.northward();
        double change = Math.hypot(moreEast, moreNorth);
        double share = change == 0 ? 0 : Math.min(1, ACCELERATION * step.seconds() / change);
        GroundVelocity apart = step.around()
                .others()
                .allowed(
                        List.of(from.spot(), step.drone()),
                        from.up(),
                        new GroundVelocity(from.eastward() + moreEast * share, from.northward() + moreNorth * share));
        double east = apart.eastward();
        double north = apart.northward();
        FlyableArea room = step.around().room();
        // The drone may be some metres beside its carrot, and does not turn sooner for a fence that is in its own way
        // only.
        double free =
                Math.min(brakingShare(room, from.spot(), east, north), brakingShare(room, step.drone(), east, north));
        return new ReferencePoint(
                new PlanePoint(
                        from.spot().eastMeters() + east * free * step.seconds(),
                        from.spot().northMeters() + north * free * step.seconds()),
                east * free,
                north * free,
                from.up(),
                from.upward());
    }

    /** The share of a speed at which whoever hears no more comes to a stand before any fence. */
    private static double brakingShare(FlyableArea room, PlanePoint from, double east, double north) {
        double speed = Math.hypot(east, north);
        double seconds = DEAF_SECONDS + speed / (2 * DEAF_BRAKING);
        double share = room.clearShare(
                from, new PlanePoint(from.eastMeters() + east * seconds, from.northMeters() + north * seconds));
        if (share >= 1) {
            return 1;
        }
        double meters = share * seconds * speed;
        double allowed =
                DEAF_BRAKING * (Math.sqrt(DEAF_SECONDS * DEAF_SECONDS + 2 * meters / DEAF_BRAKING) - DEAF_SECONDS);
        return Math.min(1, allowed / speed);
    }

    private static ReferencePoint levelled(ReferencePoint from, StandOff standOff, Cycle step) {
        GuidanceLimits limits = step.limits();
        double seconds = step.seconds();
        double wanted = within(limits, standOff.altitudeAmslMeters());
        // Nor does it evade others into the ground.
        double rise = within(limits, step.around().others().level(step.drone(), from.up(), wanted)) - from.up();
        // Whoever hears no more goes on for as long, and no farther than wanted.
        double upward = seconds == 0 ? 0 : Math.max(-SINK, Math.min(CLIMB, rise / DEAF_SECONDS));
        return new ReferencePoint(from.spot(), from.eastward(), from.northward(), from.up() + upward * seconds, upward);
    }

    private static double within(GuidanceLimits limits, double amslMeters) {
        double lowest = Math.min(limits.highestAmslMeters(), limits.lowestAmslMeters() + FLOOR_METERS);
        return Math.max(lowest, Math.min(limits.highestAmslMeters(), amslMeters));
    }

    private void updateHeading(StandOffPosition.@Nullable Wanted wanted, ReferencePoint now) {
        if (wanted == null) {
            return;
        }
        double east = wanted.target().eastMeters() - now.spot().eastMeters();
        double north = wanted.target().northMeters() - now.spot().northMeters();
        // Right above it there is nowhere to turn to.
        if (Math.hypot(east, north) > LOW_METERS) {
            heading = (Math.toDegrees(Math.atan2(east, north)) + 360) % 360;
        }
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toNanos() / NANOS;
    }
}
