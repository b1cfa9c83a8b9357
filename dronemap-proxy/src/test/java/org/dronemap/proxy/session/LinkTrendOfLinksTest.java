package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.dronemap.core.drone.LinkTrend;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The trend of a link whose messages are lost and delayed by chance, over many seeds: no false alarm, none missed. */
class LinkTrendOfLinksTest {
    /** Thresholds were chosen on others (5000 to 5099). */
    private static final int FIRST_SEED = 1_001;

    private static final int END_SEED = 1_101;
    private static final double USUAL_SECONDS = 120;
    private static final double FADE_SECONDS = 60;

    /** A link in simulated time: messages at a rate, each lost or delayed by chance. */
    private static final class SimulatedLink {
        private final Random random;
        private final double rate;
        private final LinkQualityMeter meter = new LinkQualityMeter(0);
        private final JitterMeter jitter = new JitterMeter();
        private final DoubleUnaryOperator loss;
        private final double scatterMillis;
        private double tripMillis = -1;
        private long received;
        private long lost;
        private long gap;
        private double seconds;
        private double lastHeard;
        private double burst = 1;
        private boolean inBurst;

        SimulatedLink(long seed, double rate, DoubleUnaryOperator loss, double scatterMillis) {
            this.random = new Random(seed);
            this.rate = rate;
            this.loss = loss;
            this.scatterMillis = scatterMillis;
        }

        /** One second. */
        LinkTrend goOn() {
            for (int i = 0; i < rate; i++) {
                double at = seconds + i / rate;
                if (isLost(loss.applyAsDouble(at))) {
                    gap++;
                } else {
                    received++;
                    lost += gap;
                    gap = 0;
                    lastHeard = at;
                    double delay = scatterMillis * 2 * random.nextDouble();
                    jitter.arrived(30, at, (long) ((at + delay / 1_000) * 1e9));
                }
            }
            seconds++;
            double trip = 20 + scatterMillis * 2 * random.nextDouble();
            tripMillis = tripMillis < 0 ? trip : tripMillis + (trip - tripMillis) / 8;
            meter.update(
                    (long) (seconds * 1e9),
                    new LinkQualityMeter.Counts(received, lost, 0),
                    tripMillis,
                    jitter.jitter());
            return meter.trend();
        }

        /** In bursts of that mean length, with the same share lost. */
        private boolean isLost(double share) {
            if (burst == 1) {
                return random.nextDouble() < share;
            }
            double begins = share / (burst * (1 - share));
            inBurst = random.nextDouble() < (inBurst ? 1 - 1 / burst : begins);
            return inBurst;
        }

        double silentSeconds() {
            return seconds - lastHeard;
        }
    }

    @ParameterizedTest
    @CsvSource({
        "10, 0, 5",
        "10, 0, 200",
        "10, 0.1, 10",
        "30, 0.1, 10",
        "4, 0.1, 50",
        "2, 0.03, 20",
        "1, 0.1, 100",
        "10, 0.25, 100",
        "3, 0.1, 20",
        "4, 0, 300",
        "2, 0.1, 20"
    })
    void aLinkThatIsAsItUsuallyIsNeverFalls(double rate, double loss, double scatterMillis) {
        for (int seed = FIRST_SEED; seed < END_SEED; seed++) {
            SimulatedLink link = new SimulatedLink(seed, rate, at -> loss, scatterMillis);
            for (int i = 0; i < 1_800; i++) {
                assertThat(link.goOn().isFalling())
                        .as("seed %d after %d s", seed, i)
                        .isFalse();
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "10, 0, 5, 99",
        "10, 0, 200, 99",
        "10, 0.1, 10, 99",
        "30, 0.1, 10, 99",
        "10, 0.25, 100, 97",
        "4, 0.1, 50, 97",
        "4, 0, 50, 97",
        "3, 0.1, 20, 95",
        "2, 0.02, 20, 95",
        "2, 0.1, 20, 65"
    })
    void aLinkThatFadesIsSeenToFallBeforeItIsLost(double rate, double usual, double scatterMillis, int least) {
        int seen = 0;
        for (int seed = FIRST_SEED; seed < END_SEED; seed++) {
            SimulatedLink link = new SimulatedLink(
                    seed,
                    rate,
                    at -> at < USUAL_SECONDS ? usual : usual + (1 - usual) * (at - USUAL_SECONDS) / FADE_SECONDS,
                    scatterMillis);
            double fell = 0;
            while (link.silentSeconds() < 5) {
                boolean falls = link.goOn().isFalling();
                fell = falls && fell == 0 && link.seconds > USUAL_SECONDS ? link.seconds : fell;
            }
            if (fell > 0) {
                seen++;
            }
        }
        assertThat(seen).isGreaterThanOrEqualTo(least);
    }

    /** Some five messages in a row are lost each time, as behind a tree. */
    @ParameterizedTest
    @CsvSource({"10, 0.02", "10, 0.1", "30, 0.1", "4, 0.02", "4, 0.1"})
    void aLinkThatLosesInBurstsHardlyEverFalls(double rate, double loss) {
        int fell = 0;
        for (int seed = FIRST_SEED; seed < END_SEED; seed++) {
            SimulatedLink link = new SimulatedLink(seed, rate, at -> loss, 20);
            link.burst = 5;
            boolean falls = false;
            for (int i = 0; i < 1_800; i++) {
                falls |= link.goOn().isFalling();
            }
            fell += falls ? 1 : 0;
        }
        assertThat(fell).isLessThanOrEqualTo(3);
    }

    @Test
    void aVehicleThatSpeaksSeldomIsNotJudged() {
        for (int seed = FIRST_SEED; seed < END_SEED; seed++) {
            Random random = new Random(seed);
            LinkQualityMeter meter = new LinkQualityMeter(0);
            long received = 0;
            long next = 10;
            for (int second = 1; second < 3_600; second++) {
                if (second == next) {
                    received++;
                    next += 10 + random.nextInt(50);
                }
                meter.update(
                        second * 1_000_000_000L,
                        new LinkQualityMeter.Counts(received, received / 10, 0),
                        null,
                        JitterMeter.Jitter.UNKNOWN);
                assertThat(meter.trend().state()).isEqualTo(LinkTrend.State.UNKNOWN);
            }
        }
    }

    @Test
    void aGapAloneIsNoFall() {
        for (int seed = FIRST_SEED; seed < END_SEED; seed++) {
            SimulatedLink link = new SimulatedLink(seed, 10, at -> at > 100 && at < 103 ? 1 : 0.02, 20);
            for (int i = 0; i < 300; i++) {
                assertThat(link.goOn().isFalling())
                        .as("seed %d after %d s", seed, i)
                        .isFalse();
            }
        }
    }

    @Test
    void oneThatRecoversIsSteadyAgain() {
        SimulatedLink link = new SimulatedLink(1, 10, at -> at < 120 ? 0 : at < 155 ? (at - 120) / 60 : 0.01, 20);
        boolean fell = false;
        for (int i = 0; i < 200; i++) {
            fell |= link.goOn().isFalling();
        }
        assertThat(fell).isTrue();
        assertThat(link.meter.trend().state()).isEqualTo(LinkTrend.State.STEADY);
    }
}
