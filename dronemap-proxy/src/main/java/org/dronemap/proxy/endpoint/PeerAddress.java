package org.dronemap.proxy.endpoint;

import java.net.InetSocketAddress;

/** The address of a peer: numeric IP address and port, or the device of a serial line and port 0. */
public record PeerAddress(String host, int port) {
    static PeerAddress of(InetSocketAddress address) {
        return address.getAddress() == null
                ? new PeerAddress(address.getHostString(), address.getPort())
                : new PeerAddress(address.getAddress().getHostAddress(), address.getPort());
    }

    @Override
    public String toString() {
        return port == 0 ? host : host + ":" + port;
    }
}
