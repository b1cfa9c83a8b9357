package org.dronemap.proxy.outlet.uplink;

import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.proxy.outlet.client.OutletClient;

/**
 * A message of a ground station at the outlet that is addressed to a connected drone which it may see. Owned by the
 * outlet's thread.
 */
record ClientRequest(OutletClient client, DroneId drone, VehicleFrameCache vehicle, Frame frame) {
    /** In which it is answered. */
    private ClientReplySender replySender() {
        return new ClientReplySender(client, drone, vehicle);
    }

    /** Answers in the name of the drone's autopilot. */
    void answer(Message message) {
        replySender().send(message);
    }

    /** Who asked, as an answer is addressed. */
    int fromSystem() {
        return frame.systemId();
    }

    int fromComponent() {
        return frame.componentId();
    }

    /** Says why not, in as many parts as that takes. */
    void explain(String sentence) {
        replySender().explain(sentence);
    }
}
