package org.dronemap.mavlink.signing;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.mavlink.Frame;
import org.jspecify.annotations.Nullable;

/**
 * Verifies the signatures of received MAVLink frames with one key, and refuses replayed ones. The last timestamp of
 * each stream (system, component, link id) is remembered, for a bounded number of streams. Only a frame that is judged
 * valid changes anything. Not thread-safe.
 */
public final class SignatureCheck {
    static final int MOST_STREAMS = 64;
    private static final long MINUTE = 60 * SigningClock.TICKS_PER_SECOND;

    private final SigningKey key;
    private final SigningClock clock;
    private final Map<Integer, Long> lastOfStream = new HashMap<>();

    public SignatureCheck(SigningKey key, SigningClock clock) {
        this.key = key;
        this.clock = clock;
    }

    public SignatureVerdict judge(Frame frame) {
        if (!frame.signed()) {
            return SignatureVerdict.UNSIGNED;
        }
        if (!key.signed(frame)) {
            return SignatureVerdict.BAD_SIGNATURE;
        }
        int stream = frame.systemId() << 16 | frame.componentId() << 8 | frame.signatureLinkId();
        SignatureVerdict verdict = time(lastOfStream.get(stream), frame.signatureTimestamp());
        if (verdict.isValid()) {
            lastOfStream.put(stream, frame.signatureTimestamp());
            clock.follow(frame.signatureTimestamp());
        }
        return verdict;
    }

    private SignatureVerdict time(@Nullable Long last, long timestamp) {
        if (last != null) {
            return timestamp > last ? SignatureVerdict.VALID : SignatureVerdict.REPLAYED;
        }
        if (timestamp + MINUTE < clock.now()) {
            return SignatureVerdict.TOO_OLD;
        }
        return lastOfStream.size() < MOST_STREAMS ? SignatureVerdict.VALID : SignatureVerdict.TOO_MANY_STREAMS;
    }
}
