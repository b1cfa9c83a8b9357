package org.dronemap.cognitive.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.SplittableRandom;
import org.dronemap.cognitive.follow.TargetFilter.FixResult;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.PlanePoint;
import org.junit.jupiter.api.Test;

/** Where somebody is, was and will be, by what a phone says. */
class TargetFilterTest {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    private static final double ACCURACY = 5;

    private final TargetFilter filter = new TargetFilter(new Geodetic(47.4, 8.5));

    private FixResult heard(double seconds, double east, double north) {
        return heard(seconds, east, north, ACCURACY);
    }

    private FixResult heard(double seconds, double east, double north, double accuracy) {
        return filter.update(new PhoneFix(at(seconds), filter.plane().place(new PlanePoint(east, north)), accuracy));
    }

    private static Instant at(double seconds) {
        return ZERO.plusNanos((long) (seconds * 1e9));
    }

    private void runsEast(int seconds) {
        for (int second = 0; second <= seconds; second++) {
            assertThat(heard(second, 4 * second, 0)).isEqualTo(FixResult.TAKEN);
        }
    }

    private double missed(double seconds, double east, double north) {
        PlanarMotion expected = filter.at(at(seconds));
        assertThat(expected).isNotNull();
        return expected.spot().distanceMeters(new PlanePoint(east, north));
    }

    @Test
    void foretellsWhereARunnerWillBe() {
        runsEast(10);
        assertThat(missed(11.2, 44.8, 0)).isLessThan(0.5);
        assertThat(filter.at(at(11)).eastward()).isBetween(3.7, 4.3);
    }

    @Test
    void foretellsACyclistInABend() {
        double radius = 40;
        double turn = 8 / radius;
        for (int second = 0; second <= 15; second++) {
            heard(second, radius * Math.sin(turn * second), radius * (1 - Math.cos(turn * second)));
        }
        double later = 16.2;
        assertThat(missed(later, radius * Math.sin(turn * later), radius * (1 - Math.cos(turn * later))))
                .isLessThan(2);
    }

    @Test
    void tellsABendTwoFixesAfterItBegan() {
        double radius = 40;
        double turn = 8 / radius;
        for (int second = -15; second <= 2; second++) {
            double angle = turn * Math.max(0, second);
            heard(20 + second, radius * Math.sin(angle) + Math.min(0, 8 * second), radius * (1 - Math.cos(angle)));
        }
        double later = turn * 3.3;
        assertThat(missed(23.3, radius * Math.sin(later), radius * (1 - Math.cos(later))))
                .isLessThan(0.8);
    }

    /** On average, of somebody who runs eastwards, by a phone that always says that it is right within 5 m. */
    private double speedMissed(double wander, double fresh) {
        SplittableRandom random = new SplittableRandom(7);
        double east = 0;
        double north = 0;
        double missed = 0;
        for (int second = 0; second < 400; second++) {
            east += wander * random.nextGaussian();
            north += wander * random.nextGaussian();
            heard(second, 4 * second + east + fresh * random.nextGaussian(), north + fresh * random.nextGaussian());
            PlanarMotion motion = filter.at(at(second + 0.6));
            missed += second < 20 ? 0 : Math.hypot(motion.eastward() - 4, motion.northward());
        }
        return missed / 380;
    }

    @Test
    void tellsTheSpeedByAPhoneThatIsBetterThanItSays() {
        assertThat(speedMissed(0.02, 0.05)).isLessThan(0.1);
    }

    @Test
    void tellsTheSpeedByAPhoneWhoseErrorWanders() {
        assertThat(speedMissed(0.5, 0.5)).isLessThan(0.55);
    }

    @Test
    void tellsTheSpeedByAPhoneWhoseErrorIsAnotherEachTime() {
        assertThat(speedMissed(0, 2)).isLessThan(1);
    }

    @Test
    void thinksThatNobodyGoesOnAsBeforeForLong() {
        runsEast(10);
        assertThat(filter.at(at(60)).east()).isLessThan(60);
    }

    @Test
    void believesALeapOnlyWhenItIsSaidAgainAndAgain() {
        runsEast(10);
        assertThat(heard(11, 400, 300)).isEqualTo(FixResult.OUTLIER);
        assertThat(heard(12, 48, 0)).isEqualTo(FixResult.TAKEN);
        assertThat(missed(12, 48, 0)).isLessThan(1);
        assertThat(heard(13, 400, 300)).isEqualTo(FixResult.OUTLIER);
        assertThat(heard(14, 400, 300)).isEqualTo(FixResult.OUTLIER);
        assertThat(heard(15, 400, 300)).isEqualTo(FixResult.TAKEN);
        assertThat(missed(15, 400, 300)).isLessThan(1);
    }

    @Test
    void leavesOutWhatIsOldOrVague() {
        runsEast(10);
        assertThat(heard(9.5, 300, 0)).isEqualTo(FixResult.LATE);
        assertThat(heard(11, 300, 0, 80)).isEqualTo(FixResult.VAGUE);
        assertThat(missed(11, 44, 0)).isLessThan(1);
    }

    @Test
    void beginsAnewAfterALongSilence() {
        runsEast(10);
        assertThat(heard(60, 900, 900)).isEqualTo(FixResult.TAKEN);
        assertThat(missed(60, 900, 900)).isLessThan(1);
    }

    @Test
    void tellsAPhonesTimesByTheMessageThatWentQuickest() {
        PhoneClockOffset clock = new PhoneClockOffset();
        Duration ahead = Duration.ofMillis(2_700);
        double[] ways = {0.9, 0.3, 1.4, 0.7};
        for (int second = 0; second < ways.length; second++) {
            Instant sent = at(second).plus(ahead);
            clock.messageReceived(sent, at(second + ways[second]), Duration.ofMillis((long) (ways[second] * 2_000)));
        }
        assertThat(Duration.between(at(10), clock.toCloud(at(10).plus(ahead))).abs())
                .isLessThan(Duration.ofMillis(5));
    }

    @Test
    void tellsAPhonesTimesRoughlyWhenItMeasuresNothing() {
        PhoneClockOffset clock = new PhoneClockOffset();
        clock.messageReceived(at(100), at(0.9), null);
        clock.messageReceived(at(101), at(1.2), null);
        assertThat(Duration.between(at(2), clock.toCloud(at(102))).abs()).isLessThan(Duration.ofMillis(200));
        assertThat(new PhoneClockOffset().toCloud(at(5))).isEqualTo(at(5));
    }
}
