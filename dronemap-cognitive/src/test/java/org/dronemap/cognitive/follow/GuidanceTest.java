package org.dronemap.cognitive.follow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.junit.jupiter.api.Test;

/** Where a drone is led beside its target, and where it never is. */
class GuidanceTest {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    private static final LocalPlane PLANE = new LocalPlane(SimDrone.HOME);
    private static final double AMSL = SimDrone.HOME_AMSL + 15;
    private static final Limits LIMITS = new Limits(12, SimDrone.HOME_AMSL + 5, SimDrone.HOME_AMSL + 50, 0.3);
    private static final double STEP = 0.1;

    private final Target target = new Target();
    private final Guidance guidance = new Guidance(target);
    private Whereabouts drone = at(new Spot(-40, 0), AMSL);
    private double now;

    /** Goes where the test says. */
    private static final class Target implements Followed {
        private Motion motion = new Motion(0, 0, 0, 0, 0);

        @Override
        public LocalPlane plane() {
            return PLANE;
        }

        @Override
        public Motion at(Instant time) {
            return motion.after(Duration.between(ZERO, time).toMillis() / 1e3);
        }
    }

    private static Whereabouts at(Spot spot, double amsl) {
        return new Whereabouts(ZERO, PLANE.place(spot), amsl, 0, 0);
    }

    private static Instant moment(double seconds) {
        return ZERO.plusNanos(Math.round(seconds * 1e9));
    }

    private Aim led(StandOff standOff, Limits limits, Room room, boolean heard) {
        return led(standOff, limits, new Guidance.Surroundings(room, Others.NONE), heard);
    }

    private Aim led(StandOff standOff, Limits limits, Guidance.Surroundings around, boolean heard) {
        now += STEP;
        Aim aim = guidance.lead(moment(now), standOff, limits, around, drone, heard ? moment(now) : moment(now - 2.1));
        drone = new Whereabouts(moment(now), aim.point(), aim.altitudeAmslMeters(), aim.eastward(), aim.northward());
        return aim;
    }

    private Aim led(StandOff standOff, double seconds) {
        Aim aim = led(standOff, LIMITS, Room.EVERYWHERE, true);
        for (double passed = 0; passed < seconds; passed += STEP) {
            aim = led(standOff, LIMITS, Room.EVERYWHERE, true);
        }
        return aim;
    }

    private static StandOff beside(Side side) {
        return new StandOff(side, 10, AMSL);
    }

    private static Spot spot(Aim aim) {
        return PLANE.spot(aim.point());
    }

    private static double speed(Aim aim) {
        return Math.hypot(aim.eastward(), aim.northward());
    }

    @Test
    void comesUpSmoothlyAndNeverFasterThanItMay() {
        Limits slow = new Limits(5, SimDrone.HOME_AMSL + 5, SimDrone.HOME_AMSL + 50, 0.3);
        double before = 0;
        for (int step = 0; step < 300; step++) {
            Aim aim = led(beside(new Side.Fixed(0)), slow, Room.EVERYWHERE, true);
            assertThat(speed(aim)).isLessThanOrEqualTo(5.001);
            assertThat(speed(aim) - before).isLessThan(0.26);
            before = speed(aim);
        }
        assertThat(spot(led(beside(new Side.Fixed(0)), 1)).distanceMeters(new Spot(0, 10)))
                .isLessThan(0.3);
    }

    @Test
    void staysOnTheSideThatIsAskedFor() {
        target.motion = new Motion(0, 0, 2, 0, 0);
        assertThat(fromTarget(led(beside(new Side.Behind()), 60)).eastMeters()).isBetween(-10.5, -9.5);
        assertThat(fromTarget(led(beside(new Side.Ahead()), 60)).eastMeters()).isBetween(9.5, 10.5);
        assertThat(fromTarget(led(beside(new Side.Fixed(180)), 60)).northMeters())
                .isBetween(-10.5, -9.5);
    }

    private Spot fromTarget(Aim aim) {
        Spot at = target.at(moment(now + LIMITS.downlinkSeconds())).spot();
        return new Spot(spot(aim).eastMeters() - at.eastMeters(), spot(aim).northMeters() - at.northMeters());
    }

    @Test
    void goesRoundItsTarget() {
        led(beside(new Side.Orbit(10)), 40);
        Spot before = spot(led(beside(new Side.Orbit(10)), 0));
        Spot after = spot(led(beside(new Side.Orbit(10)), 9 - STEP));
        assertThat(before.distanceMeters(new Spot(0, 0))).isBetween(9.0, 11.0);
        double turned = Math.atan2(after.eastMeters(), after.northMeters())
                - Math.atan2(before.eastMeters(), before.northMeters());
        assertThat(Math.IEEEremainder(turned, 2 * Math.PI)).isBetween(1.4, 1.75);
    }

    @Test
    void looksAtItsTarget() {
        assertThat(led(beside(new Side.Fixed(180)), 40).headingDegrees()).isBetween(0.0, 1.0);
        assertThat(led(beside(new Side.Fixed(270)), 40).headingDegrees()).isBetween(89.0, 91.0);
    }

    @Test
    void holdsTwoSecondsAfterTheNewestFix() {
        target.motion = new Motion(0, 0, 5, 0, 0);
        led(beside(new Side.Fixed(0)), 20);
        Aim aim = led(beside(new Side.Fixed(0)), LIMITS, Room.EVERYWHERE, false);
        assertThat(aim.doing()).isEqualTo(Aim.Doing.HOLDING);
        for (int step = 0; step < 40; step++) {
            aim = led(beside(new Side.Fixed(0)), LIMITS, Room.EVERYWHERE, false);
        }
        assertThat(speed(aim)).isZero();
    }

    @Test
    void climbsBeforeItGoesAnywhere() {
        drone = at(new Spot(-40, 0), SimDrone.HOME_AMSL + 2);
        Aim aim = led(beside(new Side.Fixed(0)), LIMITS, Room.EVERYWHERE, true);
        assertThat(aim.doing()).isEqualTo(Aim.Doing.CLIMBING);
        while (aim.doing() == Aim.Doing.CLIMBING) {
            assertThat(spot(aim).distanceMeters(new Spot(-40, 0))).isLessThan(0.2);
            aim = led(beside(new Side.Fixed(0)), LIMITS, Room.EVERYWHERE, true);
        }
        assertThat(drone.altitudeAmslMeters()).isGreaterThanOrEqualTo(SimDrone.HOME_AMSL + 5);
    }

    @Test
    void isNotPushedAsideWhileItClimbs() {
        Spot begins = new Spot(-40, 0);
        drone = at(begins, SimDrone.HOME_AMSL + 2);
        Whereabouts comes = new Whereabouts(ZERO, PLANE.place(new Spot(-40, 30)), SimDrone.HOME_AMSL + 6, 0, -6);
        Guidance.Surroundings crowded = new Guidance.Surroundings(
                Room.EVERYWHERE, Others.of(PLANE, List.of(new Others.Heard(comes, 0, true)), Apart.USUAL));
        Aim aim = led(beside(new Side.Fixed(0)), LIMITS, crowded, true);
        assertThat(aim.doing()).isEqualTo(Aim.Doing.CLIMBING);
        boolean heard = false;
        while (drone.altitudeAmslMeters() < LIMITS.lowestAmslMeters()) {
            aim = led(beside(new Side.Fixed(0)), LIMITS, crowded, heard);
            assertThat(spot(aim).distanceMeters(begins)).isLessThan(0.2);
            heard = !heard;
        }
        for (int step = 0; step < 20; step++) {
            aim = led(beside(new Side.Fixed(0)), LIMITS, crowded, true);
        }
        assertThat(spot(aim).distanceMeters(begins))
                .as("gives way once it is high")
                .isGreaterThan(2);
    }

    @Test
    void keepsBetweenTheLowestAndTheHighest() {
        assertThat(led(new StandOff(new Side.Fixed(0), 10, 0), 60).altitudeAmslMeters())
                .isCloseTo(SimDrone.HOME_AMSL + 5.5, within(0.01));
        assertThat(led(new StandOff(new Side.Fixed(0), 10, 5_000), 60).altitudeAmslMeters())
                .isCloseTo(SimDrone.HOME_AMSL + 50, within(0.01));
    }

    @Test
    void evadesNobodyIntoTheGround() {
        double low = SimDrone.HOME_AMSL + 6.5;
        drone = at(new Spot(0, 10), low);
        Others.Heard there = new Others.Heard(at(new Spot(2, 10), low + 1), 0, true);
        Others above = Others.of(PLANE, List.of(there), Apart.USUAL);
        double lowest = low;
        for (int step = 0; step < 100; step++) {
            now += STEP;
            Aim aim = guidance.lead(
                    moment(now),
                    new StandOff(new Side.Fixed(0), 10, low),
                    LIMITS,
                    new Guidance.Surroundings(Room.EVERYWHERE, above),
                    drone,
                    moment(now));
            lowest = Math.min(lowest, aim.altitudeAmslMeters());
        }
        assertThat(lowest).isLessThan(low - 0.5).isGreaterThanOrEqualTo(LIMITS.lowestAmslMeters());
    }

    @Test
    void waitsAtAFenceForATargetThatGoesOn() {
        Room room = room(List.of(square(0, 0, 60)), List.of());
        target.motion = new Motion(200, 0, 0, 0, 0);
        Aim aim = led(beside(new Side.Fixed(0)), LIMITS, room, true);
        for (int step = 0; step < 600; step++) {
            aim = led(beside(new Side.Fixed(0)), LIMITS, room, true);
        }
        assertThat(aim.doing()).isEqualTo(Aim.Doing.FENCED);
        assertThat(spot(aim).eastMeters()).isBetween(50.0, 55.1);
    }

    @Test
    void stopsForAFenceThatIsInTheWayOfADroneBesideItsCarrot() {
        Room room = room(List.of(), List.of(square(60, 17, 10)));
        target.motion = new Motion(-30, -20, 5, 0, 0);
        led(beside(new Side.Fixed(0)), LIMITS, room, true);
        double farthest = Double.NEGATIVE_INFINITY;
        for (int step = 0; step < 400; step++) {
            Aim aim = led(beside(new Side.Fixed(0)), LIMITS, room, true);
            Spot carrot = spot(aim);
            // A gust holds it 16 m north of where it is led at first, and the carrot waits for it.
            Spot beside = new Spot(carrot.eastMeters(), 10);
            drone = new Whereabouts(moment(now), PLANE.place(beside), AMSL, aim.eastward(), 0);
            farthest = Math.max(farthest, beside.eastMeters());
        }
        assertThat(farthest).isBetween(20.0, 45.1);
    }

    private static List<Geodetic> square(double east, double north, double half) {
        return List.of(
                PLANE.place(new Spot(east - half, north - half)),
                PLANE.place(new Spot(east + half, north - half)),
                PLANE.place(new Spot(east + half, north + half)),
                PLANE.place(new Spot(east - half, north + half)));
    }

    private static Room room(List<List<Geodetic>> stayIn, List<List<Geodetic>> keepOut) {
        return Room.of(SimDrone.HOME, stayIn, keepOut, 5);
    }

    @Test
    void fliesPastNoFenceAndNotTooLow() {
        assertThat(Tracks.fenced(0, 40).failed()).isEmpty();
    }
}
