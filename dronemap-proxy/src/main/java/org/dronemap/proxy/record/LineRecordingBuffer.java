package org.dronemap.proxy.record;

import java.nio.charset.StandardCharsets;
import java.time.Clock;
import org.dronemap.core.cloud.SendAuthority;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Buffers the text messages of one robot session for the recorder, one line of JSON each. Any thread. */
final class LineRecordingBuffer extends RecordingBuffer implements TextMessageTap {
    private static final int HALF_BYTES = 65_536;
    /** A text may need twice its length, as its quotes are escaped. */
    private static final int LONGEST = 24_576;

    LineRecordingBuffer(Clock clock, BufferBudget room, boolean always) {
        super(clock, room, always, HALF_BYTES, LONGEST + 64);
    }

    @Override
    public void received(@Nullable String text, int bytes) {
        markReceived();
        byte[] rest = rest(text, bytes, true);
        keep(rest.length, (stretch, now) -> stretch.line(now, rest, null));
    }

    @Override
    public void sent(@Nullable String text, int bytes, SendAuthority mandate) {
        byte[] rest = rest(text, bytes, false);
        keep(rest.length, (stretch, now) -> stretch.line(now, rest, mandate));
    }

    @Override
    public void working(boolean now) {
        arming(now);
    }

    @Override
    String ending() {
        return RecordingFiles.LINES;
    }

    /** What follows the time in its line. */
    private static byte[] rest(@Nullable String text, int bytes, boolean up) {
        ObjectNode line = JsonMapper.shared().createObjectNode().put("up", up).put("text", text);
        if (text == null) {
            line.put("bytes", bytes);
        }
        byte[] rest = ("," + line.toString().substring(1) + "\n").getBytes(StandardCharsets.UTF_8);
        return rest.length > LONGEST ? rest(null, bytes, up) : rest;
    }
}
