package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.Timesync;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.SigningPeer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the server says of the links themselves: loss and round trips. */
class LinkQualityTest {
    private static final Duration ANSWER = Duration.ofMillis(60);
    /** The answer, and the wire there and back. */
    private static final double LEAST_MILLIS = 70;

    private final Laboratory lab = new Laboratory(1);
    private final SigningPeer peer =
            lab.signingPeer(11).answers(Timesync.ID, this::answerLate).begin();

    @AfterEach
    void close() {
        lab.close();
    }

    private void answerLate(Frame frame) {
        Timesync asked = Timesync.decode(frame);
        if (asked.tc1() == 0) {
            peer().later(ANSWER, () -> peer().say(new Timesync(lab.time().nanos(), asked.ts1(), 0, 0)));
        }
    }

    private SigningPeer peer() {
        return peer;
    }

    private LinkQuality quality() {
        return peer.known().map(state -> state.link().quality()).orElse(LinkQuality.UNKNOWN);
    }

    private double lossShort() {
        return Objects.requireNonNull(quality().lossShort());
    }

    private double lossLong() {
        return Objects.requireNonNull(quality().lossLong());
    }

    @Test
    void lossAndRoundTripAreMeasured() {
        peer.goesOn(Duration.ofMillis(20), () -> peer.say(new Attitude(0, 0.1f, 0.2f, 0.3f, 0, 0, 0)));
        lab.until(
                "the quality is known",
                Duration.ofSeconds(20),
                () -> quality().lossShort() != null
                        && quality().lossLong() != null
                        && quality().roundTripMillis() != null);
        assertThat(lossShort()).isZero();
        assertThat(lossLong()).isZero();
        assertThat(quality().roundTripMillis()).isBetween(LEAST_MILLIS, LEAST_MILLIS + 50);

        peer.losesEvery(4);
        lab.until("a quarter is seen lost", Duration.ofSeconds(15), () -> lossShort() > 0.18);
        lab.throughout("it is seen as a quarter", Duration.ofSeconds(5), () -> lossShort() > 0.18 && lossShort() < 0.3);
        assertThat(lossLong()).isPositive().isLessThan(lossShort());

        peer.losesEvery(0);
        lab.until("the short view forgets", Duration.ofSeconds(20), () -> lossShort() < 0.05);
        assertThat(lossLong()).isGreaterThan(0.02);
    }

    @Test
    void aVehicleThatAsksForTheTimeIsToldIt() {
        peer.listed();

        long first = answer();
        lab.goOn(Duration.ofSeconds(1));

        assertThat(first).isPositive();
        assertThat(answer()).isGreaterThanOrEqualTo(first);
    }

    private long answer() {
        peer.say(new Timesync(0, 4_711, 0, 0));
        lab.goOn(Duration.ofMillis(500));
        List<Timesync> answers = peer.received(Timesync.ID).stream()
                .map(Timesync::decode)
                .filter(said -> said.ts1() == 4_711 && said.tc1() != 0)
                .toList();
        assertThat(answers).isNotEmpty();
        return answers.get(answers.size() - 1).tc1();
    }
}
