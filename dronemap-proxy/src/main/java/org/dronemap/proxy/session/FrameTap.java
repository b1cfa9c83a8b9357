package org.dronemap.proxy.session;

import java.util.List;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionItemInt;

/**
 * Listener for all frames to and from one vehicle session, such as the recorder or the outlet. Any thread; returns at
 * once.
 */
public interface FrameTap {
    /** Hears nothing. */
    FrameTap NONE = new FrameTap() {
        @Override
        public void received(Frame frame) {}

        @Override
        public void sent(byte[] frame, SendAuthority mandate) {}

        @Override
        public void bound(DroneId drone) {}

        @Override
        public void ended() {}
    };

    /** A frame came from the vehicle. */
    void received(Frame frame);

    /** A frame from the vehicle that was heard was also let in: it is no echo, and what has to be signed is. */
    default void admitted(Frame frame) {}

    /** What the vehicle keeps as its mission was read, item by item as it lies there. */
    default void missionRead(List<MissionItemInt> items) {}

    /** A frame, which belongs to the caller, went to the vehicle by that mandate. */
    void sent(byte[] frame, SendAuthority mandate);

    /** From now on the session speaks for this drone. */
    void bound(DroneId drone);

    /** The session is over. */
    void ended();

    /** Both hear, the first one first. */
    static FrameTap both(FrameTap first, FrameTap second) {
        return first == NONE ? second : new CompositeFrameTap(first, second);
    }

    /** Makes a tap for each session; {@code componentId} is the autopilot's. */
    interface Factory {
        FrameTap open(int componentId);
    }
}
