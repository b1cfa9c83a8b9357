package org.dronemap.proxy.session;

import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.mavlink.procedure.Target;

/** The way down to one vehicle, in the MAVLink version that it speaks. Owned by the session's lane. */
final class Downlink {
    private final Peer peer;
    private final FrameWriter version1 = new FrameWriter(Target.OWN_SYSTEM_ID, Target.OWN_COMPONENT_ID, 1);
    private final FrameWriter version2 = new FrameWriter(Target.OWN_SYSTEM_ID, Target.OWN_COMPONENT_ID, 2);
    private boolean speaksVersion1;

    Downlink(Peer peer) {
        this.peer = peer;
    }

    void heardVersion(int version) {
        speaksVersion1 = version == 1;
    }

    void send(Message message) {
        peer.send((speaksVersion1 ? version1 : version2).frame(message));
    }
}
