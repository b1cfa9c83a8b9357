package org.dronemap.cognitive.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.TrafficAvoidance;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/**
 * One drone follows one person, on a clock that this turns: a phone takes fixes, a network brings them, guidance says where
 * the drone shall be, a network brings that to a simulated ArduCopter. What is measured is measured against the truth.
 */
public final class FollowTrial {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    /** The phone's clock goes before the cloud's. */
    private static final Duration PHONE_AHEAD = Duration.ofMillis(2_700);

    static final double LOWEST_METERS = 5;

    private static final int SAMPLE_MILLIS = 50;
    private static final int SETPOINT_MILLIS = 100;
    private static final int TELEMETRY_MILLIS = 200;
    private static final int FIX_MILLIS = 1_000;
    private static final double REPORTED_ACCURACY = 5;

    /** What stands between the phone's fixes and the drone. */
    public enum Way {
        /** The target's motion is foretold. */
        FORESEEN,
        /** The place of the newest fix is where the target is taken to be. */
        LAST_FIX,
        /** As the paper's: each fix is sent to the drone as a place to go to. */
        FORWARDED
    }

    /** What a phone says. */
    public enum Noise {
        NONE,
        /** Its place is wrong. */
        PLACE,
        /** Its place is wrong, and it says how it moves, nearly right. */
        PLACE_AND_COURSE
    }

    /** {@code settled}: nothing is counted before, in seconds. */
    public record Setup(
            Way way,
            StandOff standOff,
            Noise noise,
            SimulatedLink.Quality link,
            double wind,
            long seed,
            double settled) {
        public Setup with(Way other) {
            return new Setup(other, standOff, noise, link, wind, seed, settled);
        }
    }

    /** Where it flies; {@code beginsMeters}: how high it is above its home when it is first led. */
    record Site(FlyableArea room, double beginsMeters) {
        static Site open(Setup setup) {
            return new Site(FlyableArea.EVERYWHERE, height(setup));
        }
    }

    /** Metres, one a sample; {@code reported}: from the place that the newest report asks for. */
    public record Result(List<Double> error, List<Double> reported, List<Double> noise) {
        public double mean() {
            return mean(error);
        }

        public static double mean(List<Double> values) {
            return values.stream().mapToDouble(Double::doubleValue).average().orElse(Double.NaN);
        }

        /** Which share of the samples is no larger: 0.95. */
        public double quantile(double share) {
            double[] sorted =
                    error.stream().mapToDouble(Double::doubleValue).sorted().toArray();
            return sorted[(int) Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
        }
    }

    private record Report(Instant sent, Geodetic point, double east, double north, PhoneFix.@Nullable Course course) {}

    private record SentSetpoint(GuidanceSetpoint aim, boolean forwarded) {}

    private final TargetPath walk;
    private final Setup setup;
    private final TestCopter drone;
    private final SimulatedLink<Report> up;
    private final SimulatedLink<SentSetpoint> down;
    private final SimulatedLink<DroneFix> telemetry;
    private final PhoneNoise phone;
    private final PhoneClockOffset clock = new PhoneClockOffset();
    private final TargetFilter filter = new TargetFilter(SimDrone.HOME);
    private final LastReportTarget last = new LastReportTarget(SimDrone.HOME);
    private final StandOffGuidance guidance;
    private final GuidanceLimits limits;
    private final FlyableArea room;
    private DroneFix seen;
    private @Nullable Instant heard;
    private @Nullable Report newest;
    private double[] off = {0, 0};

    private FollowTrial(TargetPath walk, Setup setup, FlyableArea room, TestCopter drone) {
        this.walk = walk;
        this.setup = setup;
        this.room = room;
        this.drone = drone;
        up = new SimulatedLink<>(setup.link(), setup.seed() + 1);
        down = new SimulatedLink<>(setup.link(), setup.seed() + 2);
        telemetry = new SimulatedLink<>(setup.link(), setup.seed() + 3);
        phone = new PhoneNoise(setup.seed() + 4, setup.noise() != Noise.NONE);
        guidance = new StandOffGuidance(setup.way() == Way.FORESEEN ? filter : last);
        double downlink = setup.way() == Way.FORESEEN ? setup.link().seconds() : 0;
        limits = new GuidanceLimits(15, SimDrone.HOME_AMSL + LOWEST_METERS, SimDrone.HOME_AMSL + 120, downlink);
        seen = drone.whereabouts(ZERO);
    }

    public static Result fly(TargetPath walk, Setup setup) {
        return fly(walk, setup, Site.open(setup), SampleListener.NONE);
    }

    /** Hears of each sample. */
    interface SampleListener {
        SampleListener NONE = (seconds, drone, wanted) -> {};

        void sample(double seconds, NeuPosition drone, TargetPath.Point target);
    }

    static Result fly(TargetPath walk, Setup setup, Site place, SampleListener track) {
        TestCopter drone = new SimDrone(place.beginsMeters(), setup.wind(), setup.seed());
        return new FollowTrial(walk, setup, place.room(), drone).fly(track);
    }

    /** With a copter that stands in the air over its home. */
    static Result fly(TargetPath walk, Setup setup, TestCopter drone) {
        return new FollowTrial(walk, setup, FlyableArea.EVERYWHERE, drone).fly(SampleListener.NONE);
    }

    /** Above the home of who follows, in metres. */
    static double height(Setup setup) {
        return setup.standOff().altitudeAmslMeters() - SimDrone.HOME_AMSL;
    }

    private Result fly(SampleListener track) {
        Result result = new Result(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (int millis = 0; millis < walk.seconds() * 1_000; millis += SAMPLE_MILLIS) {
            double now = millis / 1_000.0;
            if (millis % FIX_MILLIS == 0) {
                takeFix(now);
            }
            up.deliver(now, report -> hear(report, at(now)));
            telemetry.deliver(now, there -> seen = there.at().isAfter(seen.at()) ? there : seen);
            if (millis % SETPOINT_MILLIS == 0) {
                say(now);
            }
            down.deliver(now, this::told);
            track.sample(now, drone.position(), walk.at(now));
            if (now >= setup.settled()) {
                measure(now, result);
            }
            drone.live(SAMPLE_MILLIS / 1_000.0);
            if (millis % TELEMETRY_MILLIS == 0) {
                telemetry.send(now, drone.whereabouts(at(now)));
            }
        }
        return result;
    }

    private static Instant at(double seconds) {
        return ZERO.plusNanos(Math.round(seconds * 1e9));
    }

    private void takeFix(double now) {
        off = phone.next(FIX_MILLIS / 1_000.0);
        if (walk.isAsleep(now)) {
            return;
        }
        TargetPath.Point truth = walk.at(now);
        double east = truth.east() + off[0];
        double north = truth.north() + off[1];
        up.send(now, new Report(at(now).plus(PHONE_AHEAD), drone.place(east, north), east, north, course(truth)));
    }

    private PhoneFix.@Nullable Course course(TargetPath.Point truth) {
        return setup.noise() == Noise.PLACE_AND_COURSE ? phone.course(truth.eastward(), truth.northward()) : null;
    }

    private void hear(Report report, Instant now) {
        clock.messageReceived(
                report.sent(), now, Duration.ofMillis(Math.round(setup.link().seconds() * 2_000)));
        PhoneFix fix = new PhoneFix(clock.toCloud(report.sent()), report.point(), REPORTED_ACCURACY, report.course());
        filter.update(fix);
        if (newest == null || report.sent().isAfter(newest.sent())) {
            newest = report;
            last.take(fix);
            heard = now;
            if (setup.way() == Way.FORWARDED) {
                forward(report, now);
            }
        }
    }

    private void forward(Report report, Instant now) {
        double[] beside = beside();
        GuidanceSetpoint aim = new GuidanceSetpoint(
                drone.place(report.east() + beside[0], report.north() + beside[1]),
                setup.standOff().altitudeAmslMeters(),
                0,
                0,
                0,
                0,
                GuidanceSetpoint.Phase.FOLLOWING);
        down.send(Duration.between(ZERO, now).toNanos() / 1e9, new SentSetpoint(aim, true));
    }

    private void say(double now) {
        if (setup.way() != Way.FORWARDED) {
            GuidanceSetpoint aim = guidance.guide(
                    at(now),
                    setup.standOff(),
                    limits,
                    new StandOffGuidance.Environment(room, TrafficAvoidance.NONE),
                    seen,
                    heard);
            down.send(now, new SentSetpoint(aim, false));
        }
    }

    private void told(SentSetpoint said) {
        if (said.forwarded()) {
            drone.hearPlace(said.aim());
        } else {
            drone.hear(said.aim());
        }
    }

    /** East and north of the target, on the side that does not change. */
    private double[] beside() {
        double bearing = Math.toRadians(((StandOffSide.Fixed) setup.standOff().side()).bearingDegrees());
        double meters = setup.standOff().distanceMeters();
        return new double[] {meters * Math.sin(bearing), meters * Math.cos(bearing)};
    }

    private void measure(double now, Result result) {
        double[] beside = beside();
        NeuPosition here = drone.position();
        TargetPath.Point truth = walk.at(now);
        double east = here.east() - beside[0];
        double north = here.north() - beside[1];
        result.error().add(Math.hypot(east - truth.east(), north - truth.north()));
        Report report = newest;
        if (report != null) {
            result.reported().add(Math.hypot(east - report.east(), north - report.north()));
        }
        result.noise().add(Math.hypot(off[0], off[1]));
    }
}
