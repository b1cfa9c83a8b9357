package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.mavlink.message.Timesync;
import org.junit.jupiter.api.Test;

class TimesyncResponderTest {
    private static final long SECOND = 1_000_000_000L;

    private final TestWire wire = new TestWire();
    private final TimesyncResponder answers = new TimesyncResponder(wire.target());
    private long now = 1_000 * SECOND;

    private void hear(Timesync message) {
        answers.received(wire.frame(message), now);
    }

    @Test
    void tellsItsTimeBesideThatOfTheQuestion() {
        hear(new Timesync(0, 77, 0, 0));
        now += SECOND;
        hear(new Timesync(0, 78, 255, 190));

        assertThat(wire.sent(Timesync.class))
                .containsExactly(new Timesync(1_000 * SECOND, 77, 1, 1), new Timesync(1_001 * SECOND, 78, 1, 1));
    }

    @Test
    void saysNothingToAnswersAndToQuestionsForOthers() {
        hear(new Timesync(5, 77, 255, 190));
        hear(new Timesync(0, 77, 254, 190));

        assertThat(wire.sent(Timesync.class)).isEmpty();
    }

    @Test
    void isNotMadeToFloodALink() {
        for (int question = 1; question <= 1_000; question++) {
            hear(new Timesync(0, question, 0, 0));
            now += SECOND / 1_000;
        }

        assertThat(wire.sent(Timesync.class)).hasSizeBetween(45, 51);
    }
}
