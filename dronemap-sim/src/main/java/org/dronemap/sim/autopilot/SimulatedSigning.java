package org.dronemap.sim.autopilot;

import java.time.InstantSource;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.RadioStatus;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SignatureCheck;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.jspecify.annotations.Nullable;

/**
 * MAVLink signing of a simulated vehicle, as ArduPilot does it: signs, and refuses unsigned frames once it has a key. A
 * key of zeros ends it. The key outlives a reboot. Owned by the fleet's thread.
 */
public final class SimulatedSigning {
    private static final long MINUTE = 60 * SigningClock.TICKS_PER_SECOND;

    private final boolean usb;
    private final InstantSource wall;
    private @Nullable SignatureCheck check;
    private @Nullable OutgoingSigner signer;
    private long refused;

    SimulatedSigning(boolean usb, InstantSource wall) {
        this.usb = usb;
        this.wall = wall;
    }

    boolean accepts(Frame frame) {
        SignatureCheck judge = check;
        if (judge == null || judge.judge(frame).isValid() || usb || frame.messageId() == RadioStatus.ID) {
            return true;
        }
        refused++;
        return false;
    }

    byte[] frame(FrameWriter writer, Message message) {
        OutgoingSigner signs = signer;
        return signs == null ? writer.frame(message) : writer.frame(message, signs);
    }

    void setUp(SetupSigning setup) {
        byte[] secret = new byte[SigningKey.BYTES];
        boolean any = false;
        for (int i = 0; i < secret.length; i++) {
            secret[i] = (byte) setup.secretKey()[i];
            any |= secret[i] != 0;
        }
        if (!any) {
            check = null;
            signer = null;
            return;
        }
        SigningKey key = new SigningKey(secret);
        SigningClock clock = new SigningClock(wall, setup.initialTimestamp() + MINUTE);
        check = new SignatureCheck(key, clock);
        signer = new OutgoingSigner(key, clock, 0);
    }

    /** It has a key. */
    public boolean isOn() {
        return signer != null;
    }

    /** Frames that it did not listen to since it was switched on first. */
    public long refused() {
        return refused;
    }
}
