package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class PacketLossAverageTest {
    private final PacketLossAverage average = new PacketLossAverage(5);

    @Test
    void isUnknownWhileTooFewMessagesCame() {
        average.add(4, 0, 1);
        assertThat(average.share()).isNull();
        average.add(2, 0, 1);
        assertThat(average.share()).isZero();
    }

    @Test
    void followsTheLinkWithinItsMemory() {
        for (int second = 0; second < 60; second++) {
            average.add(90, 10, 1);
        }
        assertThat(average.share()).isCloseTo(0.1, Offset.offset(1e-9));
        for (int second = 0; second < 5; second++) {
            average.add(50, 50, 1);
        }
        assertThat(average.share()).isBetween(0.3, 0.4);
    }

    @Test
    void takesBackWhatCameLateAndNeverGoesBelowNothing() {
        average.add(90, 10, 1);
        average.add(110, -10, 1);
        assertThat(average.share()).isBetween(0.0, 0.01);
    }

    @Test
    void keepsItsOpinionThroughASilence() {
        average.add(50, 50, 1);
        average.add(0, 0, 3);
        assertThat(average.share()).isCloseTo(0.5, Offset.offset(1e-9));
    }
}
