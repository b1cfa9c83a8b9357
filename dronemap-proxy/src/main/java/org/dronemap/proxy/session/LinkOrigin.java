package org.dronemap.proxy.session;

import java.util.List;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.process.PeerPattern;
import org.dronemap.proxy.endpoint.Peer;
import org.jspecify.annotations.Nullable;

/**
 * Origin of a vehicle link: its transport, address key and proven identity, or a replay.
 *
 * @param replay out of a recording, nothing is ever sent
 * @param local only this machine can be on the other side
 * @param identity whom the link itself proved the other side to be; null when it proves nothing
 */
record LinkOrigin(
        DroneKey key,
        String transport,
        boolean replay,
        boolean local,
        @Nullable String identity) {
    private static final List<String> TRANSPORTS = List.of("udp", "tcp", "serial", "websocket", "dtls");

    static LinkOrigin of(Peer peer, int systemId) {
        DroneKey key = new DroneKey(peer.address().host(), peer.address().port(), systemId);
        return new LinkOrigin(
                key,
                peer.transport(),
                false,
                peer.isLocal() || isLoopback(key.address()),
                peer.authenticatedIdentity().orElse(null));
    }

    static LinkOrigin ofReplay(String transport, int number, int systemId) {
        return new LinkOrigin(new DroneKey(transport, number, systemId), transport, true, true, null);
    }

    PeerPattern peer() {
        return new PeerPattern(key.address(), key.port(), key.systemId());
    }

    /**
     * The number that signatures name the link by. One for each kind of link: vehicles remember few numbers, so an address
     * that changes must not use up new ones.
     */
    int signingLinkId() {
        int index = TRANSPORTS.indexOf(transport);
        return index < 0 ? TRANSPORTS.size() : index;
    }

    /** No packet with such a source comes in from a network. */
    private static boolean isLoopback(String host) {
        return host.startsWith("127.") || host.equals("::1") || host.equals("0:0:0:0:0:0:0:1");
    }
}
