package org.dronemap.ws.stream.delivery;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.IdentityHashMap;
import java.util.List;
import org.java_websocket.framing.Framedata;
import org.java_websocket.framing.TextFrame;

/**
 * Encodes texts of the stream as WebSocket frames, once for all clients that a text goes to in one round. Owned by the
 * pump.
 */
public final class TextFrameCache {
    private final IdentityHashMap<String, Framedata> made = new IdentityHashMap<>();

    /** The same text, by identity, is the same frame until {@link #clear}. */
    public List<Framedata> of(List<String> texts) {
        return texts.stream()
                .map(text -> made.computeIfAbsent(text, SharedTextFrame::new))
                .toList();
    }

    /** At the end of a round: what was made for it is let go. */
    public void clear() {
        made.clear();
    }

    /** Whoever sends it reads its payload from the beginning, so that it can be sent again. */
    private static final class SharedTextFrame extends TextFrame {
        SharedTextFrame(String text) {
            setPayload(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
        }

        @Override
        public ByteBuffer getPayloadData() {
            return super.getPayloadData().duplicate();
        }
    }
}
