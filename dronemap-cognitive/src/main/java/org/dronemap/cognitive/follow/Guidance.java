package org.dronemap.cognitive.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.jspecify.annotations.Nullable;

/**
 * Leads one drone beside its target. A carrot runs ahead of the drone as the drone itself could fly: it begins where the drone
 * is, keeps to speeds and fences, and comes up to where the drone has to be when it hears of it; the drone is told to be where
 * the carrot is, and to move with it. Owned by one thread.
 */
public final class Guidance {
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
    private final Stance stance;
    private @Nullable Carrot carrot;
    private @Nullable Instant before;
    private double heading;
    /** It has been as high as it has to be. */
    private boolean risen;

    /** One guidance cycle: the time that passes, and the limits for it. */
    private record Step(double seconds, Limits limits, double speed, Surroundings around, Spot drone) {
        /** Who rises goes nowhere but up, among trees as it may be: all others keep away from it. */
        Step alone() {
            return new Step(seconds, limits, speed, new Surroundings(around.room(), Others.NONE), drone);
        }
    }

    /** The flyable area and the other drones to keep away from. */
    public record Surroundings(Room room, Others others) {}

    /** The reference point that the drone follows: position in metres of the plane, velocity in m/s. */
    private record Carrot(Spot spot, double eastward, double northward, double up, double upward) {}

    /** {@code target}: whoever is followed; its filter may be told of fixes meanwhile. */
    public Guidance(Followed target) {
        plane = target.plane();
        stance = new Stance(target);
    }

    /** Begins anew from where the drone is, as when somebody else flew it meanwhile. */
    public void letGo() {
        carrot = null;
        before = null;
        risen = false;
    }

    /**
     * Where the drone shall be.
     *
     * @param heard when the newest fix of the target came; null: none did
     */
    public Aim lead(
            Instant now,
            StandOff standOff,
            Limits limits,
            Surroundings around,
            Whereabouts drone,
            @Nullable Instant heard) {
        double seconds = before == null ? 0 : Math.min(LONGEST_STEP, seconds(before, now));
        before = now;
        Instant there = now.plusNanos((long) (limits.downlinkSeconds() * NANOS));
        Spot expected = expected(drone, there);
        Carrot loose = carrot == null ? begun(drone) : carrot;
        Leash leash = leash(loose, drone, there);
        Carrot from = leashed(loose, leash, expected);
        Stance.Wanted wanted = stance.at(there, standOff, seconds);
        Step step = new Step(seconds, limits, Math.min(limits.speed(), leash.speed()), around, expected);
        Room room = around.room();
        boolean low = isLow(drone.altitudeAmslMeters(), limits);
        Carrot next;
        Aim.Doing doing;
        if (wanted == null || heard == null || Duration.between(heard, now).compareTo(PATIENCE) > 0) {
            doing = Aim.Doing.HOLDING;
            next = moved(from, 0, 0, low ? step.alone() : step);
        } else if (low) {
            doing = Aim.Doing.CLIMBING;
            next = moved(from, 0, 0, step.alone());
        } else {
            Spot free = room.nearest(wanted.spot());
            double share = room.clearShare(from.spot(), free);
            boolean fenced = share < 1 || free.distanceMeters(wanted.spot()) > LOW_METERS;
            doing = fenced ? Aim.Doing.FENCED : Aim.Doing.FOLLOWING;
            next = chase(from, wanted, at(from.spot(), free, share), fenced, step);
        }
        next = levelled(next, standOff, step);
        carrot = next;
        look(wanted, next);
        return aim(next, told(from, next, step), doing);
    }

    /** Turned on by what it turns meanwhile, slowed by half of what it brakes, and no faster. */
    private static Others.Speed told(Carrot from, Carrot next, Step step) {
        double speed = Math.hypot(next.eastward(), next.northward());
        if (step.seconds() == 0 || speed == 0) {
            return new Others.Speed(next.eastward(), next.northward());
        }
        double share = TURNING_SECONDS / step.seconds();
        double slower = Math.max(0, Math.hypot(from.eastward(), from.northward()) - speed) * share / 2;
        double aside = next.eastward() * from.northward() - next.northward() * from.eastward();
        double turned = aside / speed * share;
        double size = Math.max(0, speed - slower) / Math.hypot(speed, turned);
        double across = turned / speed * size;
        double east = next.eastward() * size + next.northward() * across;
        double north = next.northward() * size - next.eastward() * across;
        Others.Speed apart = step.around()
                .others()
                .allowed(List.of(next.spot(), step.drone()), next.up(), new Others.Speed(east, north));
        double free = freely(step.around().room(), next.spot(), apart.eastward(), apart.northward());
        return new Others.Speed(apart.eastward() * free, apart.northward() * free);
    }

    /** A gust that presses it down a little does not hold it up once it has risen. */
    private boolean isLow(double amslMeters, Limits limits) {
        risen |= amslMeters >= limits.lowestAmslMeters();
        return amslMeters < limits.lowestAmslMeters() - (risen ? LOW_METERS : 0);
    }

    private Aim aim(Carrot next, Others.Speed told, Aim.Doing doing) {
        return new Aim(
                plane.place(next.spot()), next.up(), told.eastward(), told.northward(), next.upward(), heading, doing);
    }

    private Carrot begun(Whereabouts drone) {
        return new Carrot(
                plane.spot(drone.point()), drone.eastward(), drone.northward(), drone.altitudeAmslMeters(), 0);
    }

    private Leash leash(Carrot from, Whereabouts drone, Instant there) {
        return Leash.of(
                expected(drone, there).distanceMeters(from.spot()),
                Math.hypot(drone.eastward(), drone.northward()),
                late(drone, there));
    }

    /** The drone may be blown away, or be slower than it should: then the carrot waits for it. */
    private static Carrot leashed(Carrot from, Leash leash, Spot expected) {
        double apart = expected.distanceMeters(from.spot());
        double speed = Math.hypot(from.eastward(), from.northward());
        double slower = speed > leash.speed() ? leash.speed() / speed : 1;
        return new Carrot(
                apart <= leash.meters() ? from.spot() : at(expected, from.spot(), leash.meters() / apart),
                from.eastward() * slower,
                from.northward() * slower,
                from.up(),
                from.upward());
    }

    private Spot expected(Whereabouts drone, Instant there) {
        double late = late(drone, there);
        Spot last = plane.spot(drone.point());
        return new Spot(last.eastMeters() + drone.eastward() * late, last.northMeters() + drone.northward() * late);
    }

    private static double late(Whereabouts drone, Instant there) {
        return Math.max(0, Math.min(2, seconds(drone.at(), there)));
    }

    private static Spot at(Spot from, Spot to, double share) {
        return new Spot(
                from.eastMeters() + (to.eastMeters() - from.eastMeters()) * share,
                from.northMeters() + (to.northMeters() - from.northMeters()) * share);
    }

    private static Carrot chase(Carrot from, Stance.Wanted wanted, Spot to, boolean fenced, Step step) {
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
    private static Carrot moved(Carrot from, double eastward, double northward, Step step) {
        double faster = Math.max(1, Math.hypot(eastward, northward) / step.speed());
        double moreEast = eastward / faster - from.eastward();
        double moreNorth = northward / faster - from.northward();
        double change = Math.hypot(moreEast, moreNorth);
        double share = change == 0 ? 0 : Math.min(1, ACCELERATION * step.seconds() / change);
        Others.Speed apart = step.around()
                .others()
                .allowed(
                        List.of(from.spot(), step.drone()),
                        from.up(),
                        new Others.Speed(from.eastward() + moreEast * share, from.northward() + moreNorth * share));
        double east = apart.eastward();
        double north = apart.northward();
        Room room = step.around().room();
        // The drone may be some metres beside its carrot, and does not turn sooner for a fence that is in its own way
        // only.
        double free = Math.min(freely(room, from.spot(), east, north), freely(room, step.drone(), east, north));
        return new Carrot(
                new Spot(
                        from.spot().eastMeters() + east * free * step.seconds(),
                        from.spot().northMeters() + north * free * step.seconds()),
                east * free,
                north * free,
                from.up(),
                from.upward());
    }

    /** The share of a speed at which whoever hears no more comes to a stand before any fence. */
    private static double freely(Room room, Spot from, double east, double north) {
        double speed = Math.hypot(east, north);
        double seconds = DEAF_SECONDS + speed / (2 * DEAF_BRAKING);
        double share = room.clearShare(
                from, new Spot(from.eastMeters() + east * seconds, from.northMeters() + north * seconds));
        if (share >= 1) {
            return 1;
        }
        double meters = share * seconds * speed;
        double allowed =
                DEAF_BRAKING * (Math.sqrt(DEAF_SECONDS * DEAF_SECONDS + 2 * meters / DEAF_BRAKING) - DEAF_SECONDS);
        return Math.min(1, allowed / speed);
    }

    private static Carrot levelled(Carrot from, StandOff standOff, Step step) {
        Limits limits = step.limits();
        double seconds = step.seconds();
        double wanted = within(limits, standOff.altitudeAmslMeters());
        // Nor does it evade others into the ground.
        double rise = within(limits, step.around().others().level(step.drone(), from.up(), wanted)) - from.up();
        // Whoever hears no more goes on for as long, and no farther than wanted.
        double upward = seconds == 0 ? 0 : Math.max(-SINK, Math.min(CLIMB, rise / DEAF_SECONDS));
        return new Carrot(from.spot(), from.eastward(), from.northward(), from.up() + upward * seconds, upward);
    }

    private static double within(Limits limits, double amslMeters) {
        double lowest = Math.min(limits.highestAmslMeters(), limits.lowestAmslMeters() + FLOOR_METERS);
        return Math.max(lowest, Math.min(limits.highestAmslMeters(), amslMeters));
    }

    private void look(Stance.@Nullable Wanted wanted, Carrot now) {
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
