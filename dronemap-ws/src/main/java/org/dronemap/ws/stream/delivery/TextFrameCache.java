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
                .map(text -> made.computeIfAbsent(text, TextFrameCache::encode))
                .toList();
    }

    /** At the end of a round: what was made for it is let go. */
    public void clear() {
        made.clear();
    }

    /** The library leaves its payload as it was, ready to be sent again. */
    private static Framedata encode(String text) {
        TextFrame frame = new TextFrame();
        frame.setPayload(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
        return frame;
    }
}
