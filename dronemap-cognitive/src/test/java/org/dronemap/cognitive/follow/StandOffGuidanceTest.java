package org.dronemap.cognitive.follow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.TrafficAvoidance;
import org.junit.jupiter.api.Test;

/** Where a drone is led beside its target, and where it never is. */
class StandOffGuidanceTest {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    private static final LocalPlane PLANE = new LocalPlane(SimDrone.HOME);
    private static final double AMSL = SimDrone.HOME_AMSL + 15;
    private static final GuidanceLimits LIMITS =
            new GuidanceLimits(12, SimDrone.HOME_AMSL + 5, SimDrone.HOME_AMSL + 50, 0.3);
    private static final double STEP = 0.1;

    private final TestTarget target = new TestTarget();
    private final StandOffGuidance guidance = new StandOffGuidance(target);
    private DroneFix drone = at(new PlanePoint(-40, 0), AMSL);
    private double now;

    /** Goes where the test says. */
    private static final class TestTarget implements TrackedTarget {
        private PlanarMotion motion = new PlanarMotion(0, 0, 0, 0, 0);

        @Override
        public LocalPlane plane() {
            return PLANE;
        }

        @Override
        public PlanarMotion at(Instant time) {
            return motion.after(Duration.between(ZERO, time).toMillis() / 1e3);
        }
    }

    private static DroneFix at(PlanePoint spot, double amsl) {
        return new DroneFix(ZERO, PLANE.place(spot), amsl, 0, 0);
    }

    private static Instant moment(double seconds) {
        return ZERO.plusNanos(Math.round(seconds * 1e9));
    }

    private GuidanceSetpoint led(StandOff standOff, GuidanceLimits limits, FlyableArea room, boolean heard) {
        return led(standOff, limits, new StandOffGuidance.Environment(room, TrafficAvoidance.NONE), heard);
    }

    private GuidanceSetpoint led(
            StandOff standOff, GuidanceLimits limits, StandOffGuidance.Environment around, boolean heard) {
        now += STEP;
        GuidanceSetpoint aim =
                guidance.guide(moment(now), standOff, limits, around, drone, heard ? moment(now) : moment(now - 2.1));
        drone = new DroneFix(moment(now), aim.point(), aim.altitudeAmslMeters(), aim.eastward(), aim.northward());
        return aim;
    }

    private GuidanceSetpoint led(StandOff standOff, double seconds) {
        GuidanceSetpoint aim = led(standOff, LIMITS, FlyableArea.EVERYWHERE, true);
        for (double passed = 0; passed < seconds; passed += STEP) {
            aim = led(standOff, LIMITS, FlyableArea.EVERYWHERE, true);
        }
        return aim;
    }

    private static StandOff beside(StandOffSide side) {
        return new StandOff(side, 10, AMSL);
    }

    private static PlanePoint spot(GuidanceSetpoint aim) {
        return PLANE.spot(aim.point());
    }

    private static double speed(GuidanceSetpoint aim) {
        return Math.hypot(aim.eastward(), aim.northward());
    }

    @Test
    void comesUpSmoothlyAndNeverFasterThanItMay() {
        GuidanceLimits slow = new GuidanceLimits(5, SimDrone.HOME_AMSL + 5, SimDrone.HOME_AMSL + 50, 0.3);
        double before = 0;
        for (int step = 0; step < 300; step++) {
            GuidanceSetpoint aim = led(beside(new StandOffSide.Fixed(0)), slow, FlyableArea.EVERYWHERE, true);
            assertThat(speed(aim)).isLessThanOrEqualTo(5.001);
            assertThat(speed(aim) - before).isLessThan(0.26);
            before = speed(aim);
        }
        assertThat(spot(led(beside(new StandOffSide.Fixed(0)), 1)).distanceMeters(new PlanePoint(0, 10)))
                .isLessThan(0.3);
    }

    @Test
    void staysOnTheSideThatIsAskedFor() {
        target.motion = new PlanarMotion(0, 0, 2, 0, 0);
        assertThat(fromTarget(led(beside(new StandOffSide.Behind()), 60)).eastMeters())
                .isBetween(-10.5, -9.5);
        assertThat(fromTarget(led(beside(new StandOffSide.Ahead()), 60)).eastMeters())
                .isBetween(9.5, 10.5);
        assertThat(fromTarget(led(beside(new StandOffSide.Fixed(180)), 60)).northMeters())
                .isBetween(-10.5, -9.5);
    }

    private PlanePoint fromTarget(GuidanceSetpoint aim) {
        PlanePoint at = target.at(moment(now + LIMITS.downlinkSeconds())).spot();
        return new PlanePoint(
                spot(aim).eastMeters() - at.eastMeters(), spot(aim).northMeters() - at.northMeters());
    }

    @Test
    void goesRoundItsTarget() {
        led(beside(new StandOffSide.Orbit(10)), 40);
        PlanePoint before = spot(led(beside(new StandOffSide.Orbit(10)), 0));
        PlanePoint after = spot(led(beside(new StandOffSide.Orbit(10)), 9 - STEP));
        assertThat(before.distanceMeters(new PlanePoint(0, 0))).isBetween(9.0, 11.0);
        double turned = Math.atan2(after.eastMeters(), after.northMeters())
                - Math.atan2(before.eastMeters(), before.northMeters());
        assertThat(Math.IEEEremainder(turned, 2 * Math.PI)).isBetween(1.4, 1.75);
    }

    @Test
    void looksAtItsTarget() {
        assertThat(led(beside(new StandOffSide.Fixed(180)), 40).headingDegrees())
                .isBetween(0.0, 1.0);
        assertThat(led(beside(new StandOffSide.Fixed(270)), 40).headingDegrees())
                .isBetween(89.0, 91.0);
    }

    @Test
    void holdsTwoSecondsAfterTheNewestFix() {
        target.motion = new PlanarMotion(0, 0, 5, 0, 0);
        led(beside(new StandOffSide.Fixed(0)), 20);
        GuidanceSetpoint aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, FlyableArea.EVERYWHERE, false);
        assertThat(aim.doing()).isEqualTo(GuidanceSetpoint.Phase.HOLDING);
        for (int step = 0; step < 40; step++) {
            aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, FlyableArea.EVERYWHERE, false);
        }
        assertThat(speed(aim)).isZero();
    }

    @Test
    void climbsBeforeItGoesAnywhere() {
        drone = at(new PlanePoint(-40, 0), SimDrone.HOME_AMSL + 2);
        GuidanceSetpoint aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, FlyableArea.EVERYWHERE, true);
        assertThat(aim.doing()).isEqualTo(GuidanceSetpoint.Phase.CLIMBING);
        while (aim.doing() == GuidanceSetpoint.Phase.CLIMBING) {
            assertThat(spot(aim).distanceMeters(new PlanePoint(-40, 0))).isLessThan(0.2);
            aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, FlyableArea.EVERYWHERE, true);
        }
        assertThat(drone.altitudeAmslMeters()).isGreaterThanOrEqualTo(SimDrone.HOME_AMSL + 5);
    }

    @Test
    void isNotPushedAsideWhileItClimbs() {
        PlanePoint begins = new PlanePoint(-40, 0);
        drone = at(begins, SimDrone.HOME_AMSL + 2);
        DroneFix comes = new DroneFix(ZERO, PLANE.place(new PlanePoint(-40, 30)), SimDrone.HOME_AMSL + 6, 0, -6);
        StandOffGuidance.Environment crowded = new StandOffGuidance.Environment(
                FlyableArea.EVERYWHERE,
                TrafficAvoidance.of(
                        PLANE, List.of(new TrafficAvoidance.ReportedDrone(comes, 0, true)), Separation.USUAL));
        GuidanceSetpoint aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, crowded, true);
        assertThat(aim.doing()).isEqualTo(GuidanceSetpoint.Phase.CLIMBING);
        boolean heard = false;
        while (drone.altitudeAmslMeters() < LIMITS.lowestAmslMeters()) {
            aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, crowded, heard);
            assertThat(spot(aim).distanceMeters(begins)).isLessThan(0.2);
            heard = !heard;
        }
        for (int step = 0; step < 20; step++) {
            aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, crowded, true);
        }
        assertThat(spot(aim).distanceMeters(begins))
                .as("gives way once it is high")
                .isGreaterThan(2);
    }

    @Test
    void keepsBetweenTheLowestAndTheHighest() {
        assertThat(led(new StandOff(new StandOffSide.Fixed(0), 10, 0), 60).altitudeAmslMeters())
                .isCloseTo(SimDrone.HOME_AMSL + 5.5, within(0.01));
        assertThat(led(new StandOff(new StandOffSide.Fixed(0), 10, 5_000), 60).altitudeAmslMeters())
                .isCloseTo(SimDrone.HOME_AMSL + 50, within(0.01));
    }

    @Test
    void evadesNobodyIntoTheGround() {
        double low = SimDrone.HOME_AMSL + 6.5;
        drone = at(new PlanePoint(0, 10), low);
        TrafficAvoidance.ReportedDrone there =
                new TrafficAvoidance.ReportedDrone(at(new PlanePoint(2, 10), low + 1), 0, true);
        TrafficAvoidance above = TrafficAvoidance.of(PLANE, List.of(there), Separation.USUAL);
        double lowest = low;
        for (int step = 0; step < 100; step++) {
            now += STEP;
            GuidanceSetpoint aim = guidance.guide(
                    moment(now),
                    new StandOff(new StandOffSide.Fixed(0), 10, low),
                    LIMITS,
                    new StandOffGuidance.Environment(FlyableArea.EVERYWHERE, above),
                    drone,
                    moment(now));
            lowest = Math.min(lowest, aim.altitudeAmslMeters());
        }
        assertThat(lowest).isLessThan(low - 0.5).isGreaterThanOrEqualTo(LIMITS.lowestAmslMeters());
    }

    @Test
    void waitsAtAFenceForATargetThatGoesOn() {
        FlyableArea room = room(List.of(square(0, 0, 60)), List.of());
        target.motion = new PlanarMotion(200, 0, 0, 0, 0);
        GuidanceSetpoint aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, room, true);
        for (int step = 0; step < 600; step++) {
            aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, room, true);
        }
        assertThat(aim.doing()).isEqualTo(GuidanceSetpoint.Phase.FENCED);
        assertThat(spot(aim).eastMeters()).isBetween(50.0, 55.1);
    }

    @Test
    void stopsForAFenceThatIsInTheWayOfADroneBesideItsCarrot() {
        FlyableArea room = room(List.of(), List.of(square(60, 17, 10)));
        target.motion = new PlanarMotion(-30, -20, 5, 0, 0);
        led(beside(new StandOffSide.Fixed(0)), LIMITS, room, true);
        double farthest = Double.NEGATIVE_INFINITY;
        for (int step = 0; step < 400; step++) {
            GuidanceSetpoint aim = led(beside(new StandOffSide.Fixed(0)), LIMITS, room, true);
            PlanePoint carrot = spot(aim);
            // A gust holds it 16 m north of where it is led at first, and the carrot waits for it.
            PlanePoint beside = new PlanePoint(carrot.eastMeters(), 10);
            drone = new DroneFix(moment(now), PLANE.place(beside), AMSL, aim.eastward(), 0);
            farthest = Math.max(farthest, beside.eastMeters());
        }
        assertThat(farthest).isBetween(20.0, 45.1);
    }

    private static List<Geodetic> square(double east, double north, double half) {
        return List.of(
                PLANE.place(new PlanePoint(east - half, north - half)),
                PLANE.place(new PlanePoint(east + half, north - half)),
                PLANE.place(new PlanePoint(east + half, north + half)),
                PLANE.place(new PlanePoint(east - half, north + half)));
    }

    private static FlyableArea room(List<List<Geodetic>> stayIn, List<List<Geodetic>> keepOut) {
        return FlyableArea.of(SimDrone.HOME, stayIn, keepOut, 5);
    }

    @Test
    void fliesPastNoFenceAndNotTooLow() {
        assertThat(RandomFollowStudy.fenced(0, 40).failed()).isEmpty();
    }
}
