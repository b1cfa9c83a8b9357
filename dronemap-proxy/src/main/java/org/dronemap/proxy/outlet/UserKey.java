package org.dronemap.proxy.outlet;

import java.time.InstantSource;
import org.dronemap.core.access.OutletKey;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SignatureCheck;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.dronemap.mavlink.signing.Verdict;

/**
 * One user's key for the outlet: judges what the user's programs send, from wherever, and signs what they get. A frame is
 * good once for all of them. Any thread: every method holds the object's lock.
 */
final class UserKey implements FrameSigner {
    private static final int OUTLET_LINK = 0;

    private final String user;
    private final SigningKey key;
    private final SigningClock clock;
    private final SignatureCheck check;
    private final OutgoingSigner signer;
    private long storedStamp;
    private volatile boolean withdrawn;

    UserKey(OutletKey kept, InstantSource time) {
        user = kept.user();
        key = new SigningKey(kept.key().secret());
        clock = new SigningClock(time, kept.stamp());
        check = new SignatureCheck(key, clock);
        signer = new OutgoingSigner(key, clock, OUTLET_LINK);
        storedStamp = kept.stamp();
    }

    String user() {
        return user;
    }

    /** True when this key made the frame's signature; says nothing of its time. */
    boolean signed(Frame frame) {
        return key.signed(frame);
    }

    synchronized Verdict judge(Frame frame) {
        return check.judge(frame);
    }

    @Override
    public synchronized void sign(byte[] frame) {
        signer.sign(frame);
    }

    /** The last number that was given or heard, when that was not stored yet; else 0. */
    synchronized long unstoredStamp() {
        long now = clock.now();
        if (now <= storedStamp) {
            return 0;
        }
        storedStamp = now;
        return now;
    }

    /** The user has another passphrase now, or none. */
    void withdraw() {
        withdrawn = true;
    }

    boolean isWithdrawn() {
        return withdrawn;
    }
}
