package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;

class DuplicateFrameFilterTest {
    private static final Heartbeat BEAT = new Heartbeat(2, 3, 81, 4, 4, 3);

    private final DuplicateFrameFilter echoes = new DuplicateFrameFilter();

    @Test
    void tellsACopyFromANewMessageOfTheSameWords() {
        FrameWriter writer = new FrameWriter(1, 1, 2);
        Frame first = CapturingPeer.frame(writer, BEAT);
        Frame second = CapturingPeer.frame(writer, BEAT);
        assertThat(echoes.isEcho(first)).isFalse();
        assertThat(echoes.isEcho(second)).isFalse();
        assertThat(echoes.isEcho(first)).isTrue();
        assertThat(echoes.isEcho(second)).isTrue();
    }

    @Test
    void takesNoMessageForACopyWhenTheNumbersComeRound() {
        FrameWriter writer = new FrameWriter(1, 1, 2);
        for (int i = 0; i < 1_000; i++) {
            assertThat(echoes.isEcho(CapturingPeer.frame(writer, BEAT)))
                    .as("message %d", i)
                    .isFalse();
        }
    }
}
