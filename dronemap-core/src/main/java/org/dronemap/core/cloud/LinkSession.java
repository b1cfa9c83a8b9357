package org.dronemap.core.cloud;

import org.dronemap.core.drone.DroneKey;

/**
 * One vehicle's session on a link as the cloud manager sees it: address, transport and the channel to send by.
 *
 * @param transport udp, tcp, … or "replay"
 * @param replay the bytes come from a recording: nothing is ever sent down
 */
public record LinkSession(DroneKey key, String transport, boolean replay, String label, VehicleChannel channel) {
    /** The same link, carried on by an older session's channel. */
    LinkSession by(VehicleChannel older) {
        return new LinkSession(key, transport, replay, label, older);
    }
}
