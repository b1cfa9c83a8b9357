package org.dronemap.cognitive.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.TrafficAvoidance;
import org.jspecify.annotations.Nullable;

/** Several drones follow at once, each its target, over one poor network, and keep apart by what the cloud hears of them. */
final class MultiFollowTrial {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    private static final LocalPlane PLANE = new LocalPlane(SimDrone.HOME);
    private static final double HIGH = 15;
    private static final double LOW = 6;
    private static final SimulatedLink.Quality LINK = new SimulatedLink.Quality(0.3, 0.1, 0.05);
    private static final double WIND = 4;
    private static final int SAMPLE_MILLIS = 50;

    private final List<Follower> followers = new ArrayList<>();
    private final @Nullable Separation apart;
    private final SplittableRandom random;
    private final double meters;
    private double lowest = Double.POSITIVE_INFINITY;
    private double farthest;
    private @Nullable CrossingDrone passer;

    /** {@code apart}: what is to be kept; null: nobody looks out for others. */
    private MultiFollowTrial(@Nullable Separation apart, SplittableRandom random) {
        this.apart = apart;
        this.random = random;
        // Where there is little room below them they evade each other all the same.
        meters = random.nextBoolean() ? HIGH : LOW;
    }

    /** Three round one target, from different sides or all behind it; where they stand is on its way. */
    static MultiFollowTrial three(@Nullable Separation apart, long seed, boolean sameSide) {
        MultiFollowTrial swarm = new MultiFollowTrial(apart, new SplittableRandom(seed));
        double stands = 3 * widest(apart);
        for (int drone = 0; drone < 3; drone++) {
            StandOffSide side = sameSide ? new StandOffSide.Behind() : new StandOffSide.Fixed(120 * drone);
            swarm.add(TargetPath.running(seed), new PlanePoint(0, 0), new PlanePoint(stands * (drone - 1), -20), side);
        }
        return swarm;
    }

    /** Ten targets that begin in a ring and go wherever they like, across each other. */
    static MultiFollowTrial ten(@Nullable Separation apart, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        MultiFollowTrial swarm = new MultiFollowTrial(apart, random);
        double ring = 4 * widest(apart);
        for (int drone = 0; drone < 10; drone++) {
            double angle = 2 * Math.PI * drone / 10;
            PlanePoint begins = new PlanePoint(ring * Math.sin(angle), ring * Math.cos(angle));
            TargetPath walk = TargetPath.one(random.nextInt(4), seed * 10 + drone);
            swarm.add(walk, begins, begins, new StandOffSide.Fixed(random.nextDouble(360)));
        }
        return swarm;
    }

    /** One whose target stands still, and one more that is led by nobody and flies past, from the south at that speed. */
    static MultiFollowTrial passed(double metersAside, double metersAway, double speed, long seed) {
        MultiFollowTrial swarm = new MultiFollowTrial(Separation.USUAL, new SplittableRandom(seed));
        List<double[]> stands = List.of(new double[] {0, 0, 0}, new double[] {300, 0, 0});
        swarm.add(
                TargetPath.recorded("stands", stands),
                new PlanePoint(0, 0),
                new PlanePoint(0, -20),
                new StandOffSide.Fixed(180));
        swarm.passer = new CrossingDrone(metersAside, -10 - metersAway, speed);
        return swarm;
    }

    /** One whose target stands still, and one that is led past it to a target 150 m farther north. */
    static MultiFollowTrial crossed(double metersAside, long seed) {
        MultiFollowTrial swarm = new MultiFollowTrial(Separation.USUAL, new SplittableRandom(seed));
        List<double[]> stands = List.of(new double[] {0, 0, 0}, new double[] {300, 0, 0});
        swarm.add(
                TargetPath.recorded("stands", stands),
                new PlanePoint(0, 0),
                new PlanePoint(0, -10),
                new StandOffSide.Fixed(180));
        swarm.add(
                TargetPath.recorded("stands", stands),
                new PlanePoint(metersAside, 150),
                new PlanePoint(metersAside, -200),
                new StandOffSide.Fixed(180));
        return swarm;
    }

    /** Flies north, faster and faster, when all others have come to rest. */
    private record CrossingDrone(double east, double north, double speed) {
        private static final double BEGINS = 20;
        private static final double ACCELERATION = 2.5;

        DroneFix at(double now, double amsl) {
            double seconds = Math.max(0, now - BEGINS);
            double faster = Math.min(seconds, speed / ACCELERATION);
            double flown = ACCELERATION * faster * faster / 2 + speed * (seconds - faster);
            return new DroneFix(
                    MultiFollowTrial.at(now),
                    PLANE.place(new PlanePoint(east, north + flown)),
                    amsl,
                    0,
                    ACCELERATION * faster);
        }
    }

    /** They begin no nearer than they are to stay. */
    private static double widest(@Nullable Separation apart) {
        return Math.max(10, apart == null ? 0 : apart.horizontalMeters());
    }

    /** One drone and whom it follows, from a stand of its own. */
    private static final class Follower {
        private final TargetPath walk;
        private final PlanePoint begins;
        private final StandOff standOff;
        private final SimDrone drone;
        private final TargetFilter filter = new TargetFilter(SimDrone.HOME);
        private final StandOffGuidance guidance = new StandOffGuidance(filter);
        private final SimulatedLink<PhoneFix> up;
        private final SimulatedLink<GuidanceSetpoint> down;
        private final SimulatedLink<DroneFix> telemetry;
        private final PhoneNoise noise;
        private DroneFix seen;
        private @Nullable Instant heard;

        Follower(TargetPath walk, PlanePoint begins, PlanePoint home, StandOff standOff, long seed) {
            this.walk = walk;
            this.begins = begins;
            this.standOff = standOff;
            drone = new SimDrone(PLANE.place(home), standOff.altitudeAmslMeters() - SimDrone.HOME_AMSL, WIND, seed);
            up = new SimulatedLink<>(LINK, seed + 1);
            down = new SimulatedLink<>(LINK, seed + 2);
            telemetry = new SimulatedLink<>(LINK, seed + 3);
            noise = new PhoneNoise(seed + 4, true);
            seen = drone.whereabouts(ZERO);
        }

        void phone(double now) {
            double[] off = noise.next(1);
            TargetPath.Point truth = walk.at(now);
            PlanePoint said = new PlanePoint(
                    begins.eastMeters() + truth.east() + off[0], begins.northMeters() + truth.north() + off[1]);
            up.send(now, new PhoneFix(at(now), PLANE.place(said), 5));
        }

        void hear(double now) {
            up.deliver(now, fix -> {
                filter.update(fix);
                heard = at(now);
            });
            telemetry.deliver(now, there -> seen = there.at().isAfter(seen.at()) ? there : seen);
        }

        void say(double now, TrafficAvoidance others) {
            GuidanceLimits limits = new GuidanceLimits(
                    12, SimDrone.HOME_AMSL + FollowTrial.LOWEST_METERS, SimDrone.HOME_AMSL + 120, LINK.seconds());
            down.send(
                    now,
                    guidance.guide(
                            at(now),
                            standOff,
                            limits,
                            new StandOffGuidance.Environment(FlyableArea.EVERYWHERE, others),
                            seen,
                            heard));
        }

        void live(double now, boolean tells) {
            down.deliver(now, drone::hear);
            drone.live(SAMPLE_MILLIS / 1_000.0);
            if (tells) {
                telemetry.send(now, drone.whereabouts(at(now)));
            }
        }
    }

    private void add(TargetPath walk, PlanePoint begins, PlanePoint home, StandOffSide side) {
        followers.add(new Follower(
                walk,
                begins,
                home,
                new StandOff(side, 10, SimDrone.HOME_AMSL + meters),
                random.nextLong(Integer.MAX_VALUE)));
    }

    /** The least that two were apart, in metres on the ground, while they were not one above the other. */
    double fly(double seconds) {
        double least = Double.POSITIVE_INFINITY;
        for (int millis = 0; millis < seconds * 1_000; millis += SAMPLE_MILLIS) {
            double now = millis / 1_000.0;
            for (Follower one : followers) {
                if (millis % 1_000 == 0) {
                    one.phone(now);
                }
                one.hear(now);
            }
            for (Follower one : followers) {
                if (millis % 100 == 0) {
                    one.say(now, others(one, now));
                }
                one.live(now, millis % 200 == 0);
            }
            least = Math.min(least, nearest(now));
        }
        return least;
    }

    private TrafficAvoidance others(Follower one, double now) {
        if (apart == null) {
            return TrafficAvoidance.NONE;
        }
        List<TrafficAvoidance.ReportedDrone> all = followers.stream()
                .filter(other -> other != one)
                .map(other -> new TrafficAvoidance.ReportedDrone(other.seen, late(other.seen, now), true))
                .collect(Collectors.toCollection(ArrayList::new));
        if (passer != null) {
            DroneFix seen = passer.at(Math.max(0, now - LINK.seconds()), SimDrone.HOME_AMSL + meters);
            all.add(new TrafficAvoidance.ReportedDrone(seen, late(seen, now), false));
        }
        return TrafficAvoidance.of(PLANE, all, apart);
    }

    private static double late(DroneFix there, double now) {
        return Math.min(2, Duration.between(there.at(), at(now)).toMillis() / 1e3 + LINK.seconds());
    }

    private double nearest(double now) {
        double least = Double.POSITIVE_INFINITY;
        double level = apart == null ? Separation.USUAL.verticalMeters() : apart.verticalMeters();
        List<DroneFix> real = followers.stream()
                .map(one -> one.drone.whereabouts(at(now)))
                .collect(Collectors.toCollection(ArrayList::new));
        boolean waits = passer != null && now < CrossingDrone.BEGINS;
        farthest = waits ? 0 : Math.max(farthest, fromTargets(followers.subList(0, 1), now));
        if (passer != null) {
            real.add(passer.at(now, SimDrone.HOME_AMSL + meters));
        }
        for (int i = 0; i < real.size(); i++) {
            lowest = Math.min(lowest, real.get(i).altitudeAmslMeters() - SimDrone.HOME_AMSL);
            for (int k = 0; k < i; k++) {
                double up = real.get(i).altitudeAmslMeters() - real.get(k).altitudeAmslMeters();
                if (Math.abs(up) < level) {
                    PlanePoint one = PLANE.spot(real.get(i).point());
                    least = Math.min(
                            least, one.distanceMeters(PLANE.spot(real.get(k).point())));
                }
            }
        }
        return least;
    }

    /** Metres of the first drone from its target, at the worst moment. */
    double farthest() {
        return farthest;
    }

    /** Metres above its home that any was at the least. */
    double lowest() {
        return lowest;
    }

    /** Mean metres of the drones from their targets, as they are now. */
    double fromTargets(double now) {
        return fromTargets(followers, now);
    }

    private static double fromTargets(List<Follower> some, double now) {
        return some.stream()
                .mapToDouble(one -> {
                    PlanePoint here = PLANE.spot(one.drone.whereabouts(at(now)).point());
                    TargetPath.Point truth = one.walk.at(now);
                    return Math.hypot(
                            here.eastMeters() - one.begins.eastMeters() - truth.east(),
                            here.northMeters() - one.begins.northMeters() - truth.north());
                })
                .average()
                .orElse(Double.NaN);
    }

    private static Instant at(double seconds) {
        return ZERO.plusNanos(Math.round(seconds * 1e9));
    }
}
