package org.dronemap.proxy.endpoint;

import java.net.InetSocketAddress;

/**
 * Where a peer is: numeric IP address and port, or for a line without addresses its device, such as {@code /dev/ttyUSB0},
 * and port 0.
 */
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
