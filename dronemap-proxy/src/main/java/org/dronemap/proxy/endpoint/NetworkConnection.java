package org.dronemap.proxy.endpoint;

import java.net.InetSocketAddress;

/** A connection that the server opened to a network address, by which its peer is named. */
interface NetworkConnection extends OutboundConnection {
    InetSocketAddress remote();

    @Override
    default PeerAddress address() {
        return PeerAddress.of(remote());
    }

    @Override
    default boolean isLocal() {
        return SocketAddresses.isLocal(remote());
    }
}
