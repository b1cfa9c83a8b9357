package org.dronemap.ws.lab;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SignatureCheck;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.jspecify.annotations.Nullable;

/** The keys of a scripted vehicle: it takes them as ArduPilot does, and then listens to nothing that is not signed. */
public final class PeerSigning {
    public static final long MINUTE = 60 * SigningClock.TICKS_PER_SECOND;

    private final InstantSource wall;
    private final List<String> keys = new ArrayList<>();
    private boolean takesKeys = true;
    private @Nullable OutgoingSigner signer;
    private @Nullable SignatureCheck check;
    private long good;
    private long refused;

    PeerSigning(InstantSource wall) {
        this.wall = wall;
    }

    /** At once, with a time a minute after the one that came along; zeros end it. False: it keeps what it has. */
    boolean take(SetupSigning setup) {
        byte[] secret = new byte[SigningKey.BYTES];
        boolean any = false;
        for (int i = 0; i < secret.length; i++) {
            secret[i] = (byte) setup.secretKey()[i];
            any |= secret[i] != 0;
        }
        keys.add(HexFormat.of().formatHex(secret));
        if (!takesKeys) {
            return false;
        }
        if (any) {
            use(secret, setup.initialTimestamp() + MINUTE);
        } else {
            signer = null;
            check = null;
        }
        return true;
    }

    /** Signs with that from now on, beginning after that time. */
    public void use(byte[] secret, long timestamp) {
        SigningKey key = new SigningKey(secret);
        SigningClock clock = new SigningClock(wall, timestamp);
        signer = new OutgoingSigner(key, clock, 0);
        check = new SignatureCheck(key, clock);
    }

    /** What it says is not signed any more, though it has its key. */
    public void forgetToSign() {
        signer = null;
    }

    /** From now on keys do not change anything. */
    public void ignoreKeys() {
        takesKeys = false;
    }

    byte[] frame(FrameWriter writer, Message message) {
        OutgoingSigner signs = signer;
        return signs == null ? writer.frame(message) : writer.frame(message, signs);
    }

    boolean accepts(Frame frame) {
        SignatureCheck judge = check;
        if (judge == null) {
            return true;
        }
        boolean valid = judge.judge(frame).isValid();
        good += valid ? 1 : 0;
        refused += valid ? 0 : 1;
        return valid;
    }

    /** That came to it, in hexadecimal, oldest first. */
    public List<String> keys() {
        return List.copyOf(keys);
    }

    /** Messages of the server that were rightly signed. */
    public long good() {
        return good;
    }

    /** Messages of the server that were not, since it has a key. */
    public long refused() {
        return refused;
    }

    /** Ticks of signatures at this moment. */
    public long now() {
        return SigningClock.timestampOf(wall.instant());
    }

    /** The same signed frame with another signature. */
    public static byte[] signedAgain(byte[] frame, byte[] secret, long timestamp, int linkId) {
        byte[] again = frame.clone();
        new OutgoingSigner(new SigningKey(secret), new SigningClock(() -> Instant.EPOCH, timestamp - 1), linkId)
                .sign(again);
        return again;
    }
}
