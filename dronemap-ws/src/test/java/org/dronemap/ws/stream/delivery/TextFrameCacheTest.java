package org.dronemap.ws.stream.delivery;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.java_websocket.drafts.Draft_6455;
import org.java_websocket.framing.Framedata;
import org.junit.jupiter.api.Test;

/** A text is encoded once a round, and every client gets all of it. */
class TextFrameCacheTest {
    private static final String WORDS = "{\"name\":\"Zürich 北 🚁\"}";

    private final TextFrameCache frames = new TextFrameCache();

    @Test
    void encodesATextOnceUntilCleared() {
        Framedata first = frames.of(List.of(WORDS)).get(0);

        assertThat(frames.of(List.of(WORDS)).get(0)).isSameAs(first);
        frames.clear();
        assertThat(frames.of(List.of(WORDS)).get(0)).isNotSameAs(first);
    }

    @Test
    void sendsAllOfItToEachClient() {
        Draft_6455 draft = new Draft_6455();
        draft.setParseMode(org.java_websocket.enums.Role.SERVER);
        Framedata frame = frames.of(List.of(WORDS)).get(0);

        byte[] one = draft.createBinaryFrame(frame).array();
        byte[] another = draft.createBinaryFrame(frame).array();

        byte[] text = WORDS.getBytes(StandardCharsets.UTF_8);
        assertThat(one).hasSize(2 + text.length).startsWith(0x81, text.length).endsWith(text);
        assertThat(another).isEqualTo(one);
    }

    @Test
    void keepsTheOrder() {
        assertThat(frames.of(List.of("b", "a")))
                .extracting(frame ->
                        StandardCharsets.UTF_8.decode(frame.getPayloadData()).toString())
                .containsExactly("b", "a");
    }
}
