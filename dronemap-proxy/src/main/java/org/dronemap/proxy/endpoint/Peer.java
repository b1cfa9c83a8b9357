package org.dronemap.proxy.endpoint;

import java.util.Optional;

/** The other side of an endpoint: one address that bytes are received from and can be sent to. Any thread. */
public interface Peer {
    /** Where it is now; a peer on an authenticated link may move. */
    PeerAddress address();

    /** udp, tcp, serial, websocket, dtls. */
    String transport();

    /**
     * Who the link itself proved the other side to be: the identity of a DTLS key. Empty on links that prove nothing.
     */
    default Optional<String> authenticatedIdentity() {
        return Optional.empty();
    }

    /** True when only this machine can be on the other side: a loopback address, or a line plugged into it. */
    default boolean isLocal() {
        return false;
    }

    /** True when bytes come as whole datagrams, false when they come as a stream. */
    default boolean isDatagram() {
        return false;
    }

    /** What a WebSocket was opened to, which may hold a secret; else empty. */
    default String path() {
        return "";
    }

    /** Sends one frame; false, uncounted, when the link takes no more now. */
    default boolean offer(byte[] frame) {
        send(frame);
        return true;
    }

    /** Sends one frame, or drops and counts it when the link takes no more. */
    void send(byte[] frame);
}
