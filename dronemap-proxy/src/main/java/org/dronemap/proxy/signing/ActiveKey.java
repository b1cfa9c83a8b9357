package org.dronemap.proxy.signing;

import org.dronemap.core.access.LinkKey;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SignatureCheck;
import org.dronemap.mavlink.signing.SignatureVerdict;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;

/** One signing key of a drone in use: verifies received frames and signs sent ones. Guarded by its keyring. */
final class ActiveKey {
    private final LinkKey key;
    private final SigningKey signingKey;
    private final SigningClock clock;
    private final SignatureCheck check;

    ActiveKey(LinkKey key, SigningClock clock) {
        this.key = key;
        this.clock = clock;
        signingKey = new SigningKey(key.secret());
        check = new SignatureCheck(signingKey, clock);
    }

    LinkKey key() {
        return key;
    }

    boolean signed(Frame frame) {
        return signingKey.signed(frame);
    }

    SignatureVerdict judge(Frame frame) {
        return check.judge(frame);
    }

    FrameSigner signer(int linkId) {
        return new OutgoingSigner(signingKey, clock, linkId);
    }
}
