package org.dronemap.proxy.outlet.rights;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.InstantSource;
import org.dronemap.core.access.OutletKey;
import org.dronemap.core.access.Principal;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SignatureCheck;
import org.dronemap.mavlink.signing.SignatureVerdict;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;

/**
 * One user's outlet key: verifies what the user's ground stations send, and signs what they get. A frame is good once
 * for all of them. Any thread: every method holds the object's lock.
 */
public final class UserKey implements FrameSigner, OutletCredential {
    private static final int OUTLET_LINK = 0;

    private final String user;
    private final SigningKey key;
    private final SigningClock clock;
    private final SignatureCheck check;
    private final byte[] dtlsSecret;
    private final OutgoingSigner signer;
    /** What was signed until then may have been heard before: which streams there were is not stored. */
    private final long acceptedAfterStamp;

    private long storedStamp;
    private volatile boolean withdrawn;

    private UserKey(OutletKey kept, InstantSource time, boolean inUse) {
        user = kept.user();
        key = new SigningKey(kept.key().secret());
        dtlsSecret = digest(kept.key().secret());
        clock = new SigningClock(time, kept.stamp());
        check = new SignatureCheck(key, clock);
        signer = new OutgoingSigner(key, clock, OUTLET_LINK);
        storedStamp = kept.stamp();
        acceptedAfterStamp = inUse ? clock.now() : 0;
    }

    /** One that nobody has signed with yet. */
    static UserKey fresh(OutletKey made, InstantSource time) {
        return new UserKey(made, time, false);
    }

    /** One of an earlier process: what was signed before this one began, or before the last that was heard then, is too old. */
    static UserKey kept(OutletKey kept, InstantSource time) {
        return new UserKey(kept, time, true);
    }

    private static byte[] digest(byte[] secret) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(secret);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** What the user's programs encrypt with (the digest of the key, which nobody can sign with). */
    byte[] dtlsSecret() {
        return dtlsSecret.clone();
    }

    @Override
    public String user() {
        return user;
    }

    @Override
    public FrameSigner signer() {
        return this;
    }

    @Override
    public boolean onlyLooks() {
        return false;
    }

    /** All of them: whoever signs is the user. */
    @Override
    public Principal rights(Principal of) {
        return of;
    }

    /** True when this key made the frame's signature; says nothing of its time. */
    boolean signed(Frame frame) {
        return key.signed(frame);
    }

    public synchronized SignatureVerdict judge(Frame frame) {
        boolean early = frame.signed() && frame.signatureTimestamp() <= acceptedAfterStamp && key.signed(frame);
        return early ? SignatureVerdict.TOO_OLD : check.judge(frame);
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

    @Override
    public boolean isWithdrawn() {
        return withdrawn;
    }
}
