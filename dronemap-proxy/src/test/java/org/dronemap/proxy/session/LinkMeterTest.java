package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.procedure.RoundTripEstimator;
import org.dronemap.proxy.mavlink.procedure.RoundTripProbe;
import org.junit.jupiter.api.Test;

class LinkMeterTest {
    private static final long SECOND = 1_000_000_000L;
    private static final Heartbeat BEAT = new Heartbeat(2, 3, 81, 4, 4, 3);

    private long now = 1_000 * SECOND;
    private final LinkMeter meter =
            new LinkMeter(new RoundTripProbe(new MavlinkTarget(1, 1, message -> {}), new RoundTripEstimator()), now);

    @Test
    void countsTheNumbersOfEachComponentForThemselves() {
        FrameWriter autopilot = new FrameWriter(1, 1, 2);
        FrameWriter camera = new FrameWriter(1, 100, 2);
        for (int i = 0; i < 400; i++) {
            now += SECOND / 100;
            meter.arrived(CapturingPeer.frame(autopilot, BEAT), now);
            if (i % 5 == 0) {
                meter.arrived(CapturingPeer.frame(camera, BEAT), now);
            }
        }
        assertThat(meter.counts()).isEqualTo(new LinkQualityMeter.Counts(480, 0, 0));
    }

    @Test
    void tellsTheShareThatIsMissingOnceASecond() {
        FrameWriter autopilot = new FrameWriter(1, 1, 2);
        int told = 0;
        for (int i = 0; i < 1_000; i++) {
            now += SECOND / 100;
            byte[] frame = autopilot.frame(BEAT);
            if (i % 4 != 0) {
                meter.arrived(CapturingPeer.frame(frame), now);
            }
            told += meter.advance(now) ? 1 : 0;
        }
        assertThat(told).isLessThanOrEqualTo(10);
        assertThat(meter.quality().lossShort()).isBetween(0.2, 0.3);
        assertThat(meter.quality().lossLong()).isBetween(0.2, 0.3);
    }
}
