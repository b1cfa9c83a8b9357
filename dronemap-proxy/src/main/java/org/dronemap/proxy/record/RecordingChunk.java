package org.dronemap.proxy.record;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.tlog.TlogBuffer;
import org.jspecify.annotations.Nullable;

/** A block of recorded messages, and for those sent to the vehicle the authority they were sent by. Not thread-safe. */
final class RecordingChunk {
    private final TlogBuffer records;
    private final List<Sent> sent = new ArrayList<>();

    /** A record that went out; {@code offset} in bytes from the beginning of the stretch. */
    record Sent(int offset, SendAuthority mandate) {}

    RecordingChunk(int mostBytes) {
        records = new TlogBuffer(mostBytes);
    }

    TlogBuffer records() {
        return records;
    }

    List<Sent> sent() {
        return sent;
    }

    /** False when there is no room. */
    boolean addReceived(long micros, Frame frame) {
        return records.add(micros, frame);
    }

    /** The same for a frame that goes out. */
    boolean addSent(long micros, byte[] frame, SendAuthority mandate) {
        int offset = records.length();
        boolean kept = records.add(micros, frame);
        if (records.length() > offset) {
            sent.add(new Sent(offset, mandate));
        }
        return kept;
    }

    /** A line that needs its time yet; {@code mandate} null: it was heard. */
    boolean line(long micros, byte[] rest, @Nullable SendAuthority mandate) {
        byte[] time = ("{\"at\":" + micros).getBytes(StandardCharsets.US_ASCII);
        byte[] line = Arrays.copyOf(time, time.length + rest.length);
        System.arraycopy(rest, 0, line, time.length, rest.length);
        int offset = records.length();
        boolean kept = records.addWhole(micros, line);
        if (kept && mandate != null) {
            sent.add(new Sent(offset, mandate));
        }
        return kept;
    }

    /** Moves all of {@code other} behind what is here; false, and nothing is moved, when there is no room. */
    boolean addAll(RecordingChunk other) {
        int offset = records.length();
        if (!records.addAll(other.records)) {
            return false;
        }
        other.sent.forEach(each -> sent.add(new Sent(offset + each.offset(), each.mandate())));
        other.sent.clear();
        return true;
    }

    void clear() {
        records.clear();
        sent.clear();
    }
}
