package org.dronemap.mavlink.signing;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameSigner;

/**
 * Signs the MAVLink frames that one sender puts on one link. Timestamps rise strictly from frame to frame, also over
 * several signers of one clock. Not thread-safe.
 */
public final class OutgoingSigner implements FrameSigner {
    private final SigningKey key;
    private final SigningClock clock;
    private final int linkId;

    /** {@code linkId}, 0 to 255, tells the sender's links apart. */
    public OutgoingSigner(SigningKey key, SigningClock clock, int linkId) {
        if (linkId < 0 || linkId > 255) {
            throw new IllegalArgumentException("a link id is 0 to 255: " + linkId);
        }
        this.key = key;
        this.clock = clock;
        this.linkId = linkId;
    }

    @Override
    public void sign(byte[] frame) {
        int at = frame.length - Frame.SIGNATURE_BYTES;
        long timestamp = clock.next();
        frame[at] = (byte) linkId;
        for (int i = 0; i < 6; i++) {
            frame[at + 1 + i] = (byte) (timestamp >>> (8 * i));
        }
        System.arraycopy(key.digest(frame), 0, frame, frame.length - SigningKey.DIGEST_BYTES, SigningKey.DIGEST_BYTES);
    }
}
