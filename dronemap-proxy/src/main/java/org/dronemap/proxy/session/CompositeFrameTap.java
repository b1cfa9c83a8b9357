package org.dronemap.proxy.session;

import java.util.List;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionItemInt;

/** A frame tap that passes everything on to two others, such as the recorder and the outlet. */
record CompositeFrameTap(FrameTap first, FrameTap second) implements FrameTap {
    @Override
    public void received(Frame frame) {
        first.received(frame);
        second.received(frame);
    }

    @Override
    public void admitted(Frame frame) {
        first.admitted(frame);
        second.admitted(frame);
    }

    @Override
    public void missionRead(List<MissionItemInt> items) {
        first.missionRead(items);
        second.missionRead(items);
    }

    @Override
    public void sent(byte[] frame, SendAuthority mandate) {
        first.sent(frame, mandate);
        second.sent(frame, mandate);
    }

    @Override
    public void bound(DroneId drone) {
        first.bound(drone);
        second.bound(drone);
    }

    @Override
    public void ended() {
        first.ended();
        second.ended();
    }
}
