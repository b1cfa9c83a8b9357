package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/**
 * MAVLink message 512 (CONTROL_STATUS, development dialect): which ground station controls a vehicle. Raw fields as on
 * the wire; the ten other ground stations that it could name are none, as control is one user's.
 *
 * @param gcsMain system id of the ground station in control; 0: none
 */
public record ControlStatus(int flags, int gcsMain) implements Message {
    public static final int ID = 512;

    /** It stands for the whole vehicle, not for one component. */
    public static final int SYSTEM_MANAGER = 1;

    /** Whoever asks for control gets it. */
    public static final int TAKEOVER_ALLOWED = 2;

    private static final int SECONDARY = 10;

    public static ControlStatus decode(Frame frame) {
        return new ControlStatus(frame.u8(0), frame.u8(1));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u8(flags);
        out.u8(gcsMain);
        out.u8s(new int[0], SECONDARY);
    }
}
