package org.dronemap.proxy.endpoint;

import java.net.InetSocketAddress;

/** The other side of an endpoint: one address that bytes come from and can be sent to. Any thread. */
public interface Peer {
    InetSocketAddress address();

    /** udp, tcp. */
    String transport();

    /** Sends one frame, or drops and counts it when the socket takes no more. */
    void send(byte[] frame);
}
