package org.dronemap.proxy.mavlink.translate;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Statustext;

/**
 * The chunks of one long STATUSTEXT, in whatever order they come. Joined as bytes, since a letter may lie across two of
 * them. Owned by the drone's lane.
 */
final class StatustextChunks {
    private static final int TEXT_AT = 1;
    private static final int CHUNK = 50;
    private static final int MOST_CHUNKS = 10;
    private static final String GAP = " … ";

    private final Severity severity;
    private final int severityNumber;
    private final SortedMap<Integer, byte[]> bySequence = new TreeMap<>();
    private int last = -1;
    private long lastNanos;
    private boolean told;

    /** {@code severityNumber}: as on the wire. */
    StatustextChunks(Severity severity, int severityNumber) {
        this.severity = severity;
        this.severityNumber = severityNumber;
    }

    Severity severity() {
        return severity;
    }

    long lastNanos() {
        return lastNanos;
    }

    /** False for a chunk of another sentence with the same number; once it was told only repetitions belong to it. */
    boolean accepts(Frame frame) {
        Statustext message = Statustext.decode(frame);
        byte[] held = bySequence.get(message.chunkSeq());
        if (message.severity() != severityNumber) {
            return false;
        }
        return held == null ? !told && (last < 0 || message.chunkSeq() < last) : Arrays.equals(held, bytes(frame));
    }

    void add(Frame frame, long nowNanos) {
        byte[] text = bytes(frame);
        int sequence = Statustext.decode(frame).chunkSeq();
        bySequence.put(sequence, text);
        if (text.length < CHUNK) {
            last = sequence;
        }
        lastNanos = nowNanos;
    }

    boolean isComplete() {
        return last >= 0 && bySequence.size() == last + 1;
    }

    /** So long that what there is should be shown; the rest is a sentence of its own. */
    boolean isLong() {
        return bySequence.size() >= MOST_CHUNKS;
    }

    /** What there is, once; empty when it was told before. */
    Optional<String> textOnce() {
        if (told) {
            return Optional.empty();
        }
        told = true;
        StringBuilder text = new StringBuilder();
        ByteArrayOutputStream run = new ByteArrayOutputStream();
        int next = 0;
        for (Map.Entry<Integer, byte[]> chunk : bySequence.entrySet()) {
            if (chunk.getKey() > next) {
                text.append(clean(run)).append(GAP);
                run.reset();
            }
            run.writeBytes(chunk.getValue());
            next = chunk.getKey() + 1;
        }
        text.append(clean(run));
        return Optional.of(last < 0 ? text.append(GAP).toString() : text.toString());
    }

    private static String clean(ByteArrayOutputStream run) {
        return run.toString(StandardCharsets.UTF_8).replaceAll("[\\p{Cntrl}\\uFFFD]", "?");
    }

    private static byte[] bytes(Frame frame) {
        int length = 0;
        while (length < CHUNK && frame.u8(TEXT_AT + length) != 0) {
            length++;
        }
        byte[] text = new byte[length];
        for (int i = 0; i < length; i++) {
            text[i] = (byte) frame.u8(TEXT_AT + i);
        }
        return text;
    }
}
