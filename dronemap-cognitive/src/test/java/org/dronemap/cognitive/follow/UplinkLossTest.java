package org.dronemap.cognitive.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.separation.TrafficAvoidance;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A drone that is led towards a fence hears not a word more, at any moment: it goes on for three seconds, and then brakes. */
class UplinkLossTest {
    private static final LocalPlane PLANE = new LocalPlane(SimDrone.HOME);
    private static final double AMSL = SimDrone.HOME_AMSL + 15;
    private static final GuidanceLimits LIMITS =
            new GuidanceLimits(15, SimDrone.HOME_AMSL + 5, SimDrone.HOME_AMSL + 50, 0);
    private static final StandOff BESIDE = new StandOff(new StandOffSide.Fixed(180), 5, AMSL);
    private static final double HALF = 100;
    private static final double MARGIN = 5;
    private static final FlyableArea ROOM = FlyableArea.of(
            SimDrone.HOME,
            List.of(List.of(
                    PLANE.place(new PlanePoint(-HALF, -HALF)),
                    PLANE.place(new PlanePoint(HALF, -HALF)),
                    PLANE.place(new PlanePoint(HALF, HALF)),
                    PLANE.place(new PlanePoint(-HALF, HALF)))),
            List.of(),
            MARGIN);
    private static final double STEP = 0.1;
    private static final double FLIES_ON = 12;

    @ParameterizedTest
    @ValueSource(doubles = {4, 6, 8, 12})
    void staysWithinTheFenceWheneverTheLastWordIsSaid(double speed) {
        for (double deaf = 4; deaf < 20; deaf += 0.5) {
            assertThat(left(speed, deaf))
                    .as("deaf after %.1f s at %.0f m/s", deaf, speed)
                    .isPositive();
        }
    }

    /** Metres to the fence at the worst moment. */
    private static double left(double speed, double deaf) {
        RunningTarget runner = new RunningTarget(speed);
        StandOffGuidance guidance = new StandOffGuidance(runner);
        SimDrone drone = new SimDrone(15, 3, 1);
        double least = HALF;
        for (double now = 0; now < deaf + FLIES_ON; now += STEP) {
            Instant at = runner.at(now);
            if (now < deaf) {
                StandOffGuidance.Environment around = new StandOffGuidance.Environment(ROOM, TrafficAvoidance.NONE);
                drone.hear(guidance.guide(at, BESIDE, LIMITS, around, drone.whereabouts(at), at));
            }
            drone.live(STEP);
            least = Math.min(
                    least, ROOM.clearance(PLANE.spot(drone.whereabouts(at).point())) + MARGIN);
        }
        return least;
    }

    /** Runs east and does not stop. */
    private record RunningTarget(double speed) implements TrackedTarget {
        private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");

        Instant at(double seconds) {
            return ZERO.plusMillis(Math.round(seconds * 1_000));
        }

        @Override
        public LocalPlane plane() {
            return PLANE;
        }

        @Override
        public @Nullable PlanarMotion at(Instant time) {
            double seconds = (time.toEpochMilli() - ZERO.toEpochMilli()) / 1e3;
            return new PlanarMotion(speed * seconds, 5, speed, 0, 0);
        }
    }
}
