package org.dronemap.proxy.mavlink.translate;

import java.util.function.BiConsumer;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Statustext;

/** Joins the chunks of long STATUSTEXT messages of a vehicle into whole sentences. Owned by the drone's lane. */
final class StatustextJoiner {
    private static final int CHUNK = 50;
    private static final int LONGEST = 500;
    private static final long PATIENCE_NANOS = 1_000_000_000L;

    private final BiConsumer<Severity, String> out;
    private final StringBuilder pending = new StringBuilder();
    private int id;
    private int nextChunk;
    private Severity severity = Severity.INFO;
    private long sinceNanos;

    StatustextJoiner(BiConsumer<Severity, String> out) {
        this.out = out;
    }

    void received(Frame frame, long nowNanos) {
        Statustext message = Statustext.decode(frame);
        if (message.id() == 0) {
            publish(severity(message.severity()), message.text());
            return;
        }
        if (message.id() != id) {
            flush();
            id = message.id();
            nextChunk = 0;
            severity = severity(message.severity());
        } else if (message.chunkSeq() < nextChunk) {
            return;
        }
        if (message.chunkSeq() > nextChunk) {
            pending.append(" … ");
        }
        nextChunk = message.chunkSeq() + 1;
        pending.append(message.text());
        sinceNanos = nowNanos;
        boolean last = frame.u8(CHUNK) == 0;
        if (last || pending.length() >= LONGEST) {
            flush();
        }
    }

    /** Lets go of a sentence whose end does not come. */
    void advance(long nowNanos) {
        if (pending.length() > 0 && nowNanos - sinceNanos > PATIENCE_NANOS) {
            pending.append(" …");
            flush();
        }
    }

    private void flush() {
        String text = pending.toString();
        pending.setLength(0);
        publish(severity, text);
    }

    private void publish(Severity how, String text) {
        if (!text.isBlank()) {
            out.accept(how, text.strip());
        }
    }

    private static Severity severity(int number) {
        Severity[] all = Severity.values();
        return number < all.length ? all[number] : Severity.INFO;
    }
}
