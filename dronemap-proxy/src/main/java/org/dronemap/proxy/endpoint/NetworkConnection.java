package org.dronemap.proxy.endpoint;

import java.net.InetSocketAddress;

/** A line to an address of the network, which is what its peer is called by. */
interface NetworkConnection extends ClientConnection {
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
