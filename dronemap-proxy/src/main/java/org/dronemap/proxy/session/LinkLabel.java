package org.dronemap.proxy.session;

import java.util.List;
import org.dronemap.core.drone.DroneKey;

/** Where a session comes from; {@code replay}: out of a recording, nothing is ever sent. */
record LinkLabel(DroneKey key, String transport, boolean replay) {
    private static final List<String> TRANSPORTS = List.of("udp", "tcp", "serial", "websocket", "dtls");

    /**
     * The number that signatures name the link by. One for each kind of link: vehicles remember few numbers, so an address
     * that changes must not use up new ones.
     */
    int signingLinkId() {
        int index = TRANSPORTS.indexOf(transport);
        return index < 0 ? TRANSPORTS.size() : index;
    }
}
