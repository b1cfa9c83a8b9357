package org.dronemap.core.cloud.lane;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import org.dronemap.core.drone.LinkState;
import org.junit.jupiter.api.Test;

class WatchdogTest {
    private static final long SECOND = 1_000_000_000L;
    private final Liveness liveness = new Liveness(Watchdog.DEFAULT);

    @Test
    void callsAQuietLinkLiveUpToThreeSecondsAndLostAtFive() {
        hearEvery(3 * SECOND / 2, 60);
        long last = 59 * 3 * SECOND / 2;

        assertThat(liveness.judge(last + 2_900_000_000L)).isEqualTo(LinkState.LIVE);
        assertThat(liveness.judge(last + 3 * SECOND)).isEqualTo(LinkState.SUSPECT);
        assertThat(liveness.judge(last + 5 * SECOND)).isEqualTo(LinkState.LOST);
    }

    @Test
    void suspectsATalkativeLinkSooner() {
        hearEvery(SECOND / 100, 1000);
        long last = 999 * (SECOND / 100);

        assertThat(liveness.judge(last + 1_400_000_000L)).isEqualTo(LinkState.LIVE);
        assertThat(liveness.judge(last + 1_600_000_000L)).isEqualTo(LinkState.SUSPECT);
    }

    @Test
    void learnsThatALinkPausesNowAndThenAndForgetsItAgain() {
        hearEvery(SECOND / 100, 100);
        long afterPause = 99 * (SECOND / 100) + 1_450_000_000L;
        liveness.received(afterPause);
        assertThat(liveness.judge(afterPause + 2_800_000_000L)).isEqualTo(LinkState.LIVE);

        long last = afterPause;
        for (int i = 0; i < 20_000; i++) {
            last += SECOND / 100;
            liveness.received(last);
        }

        assertThat(liveness.judge(last + 1_600_000_000L)).isEqualTo(LinkState.SUSPECT);
    }

    @Test
    void probesOncePerSecondOfSilence() {
        liveness.received(0);

        assertThat(liveness.probeDue(2_900_000_000L)).isFalse();
        assertThat(liveness.probeDue(3 * SECOND)).isTrue();
        assertThat(liveness.probeDue(3_900_000_000L)).isFalse();
        assertThat(liveness.probeDue(4 * SECOND)).isTrue();
    }

    @Test
    void knowsNobodyThatWasNeverHeard() {
        assertThat(liveness.judge(0)).isEqualTo(LinkState.LOST);
        assertThat(liveness.probeDue(100 * SECOND)).isFalse();
    }

    @Test
    void refusesToLoseADroneBeforeItWasSuspect() {
        assertThatThrownBy(() -> new Watchdog(Duration.ofSeconds(6), Duration.ofSeconds(3), Duration.ofSeconds(5)))
                .hasMessageContaining("PT6S");
    }

    private void hearEvery(long gapNanos, int times) {
        for (int i = 0; i < times; i++) {
            liveness.received(i * gapNanos);
        }
    }
}
