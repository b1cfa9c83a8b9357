package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;

/** A door for vehicles: one socket and the one thread that reads it. */
public interface Endpoint extends AutoCloseable {
    /** Opens the door that the URL names. The failure's message says what to do. */
    static Endpoint open(EndpointUrl url, PeerHandler.Factory handlers) throws IOException {
        InetSocketAddress address = new InetSocketAddress(url.host().replaceAll("[\\[\\]]", ""), url.port());
        if (address.isUnresolved()) {
            throw new UnknownHostException("The address of " + url + " cannot be found; name one of this machine, such"
                    + " as 127.0.0.1, or 0.0.0.0 for all.");
        }
        return switch (url.transport()) {
            case UDP -> UdpServerEndpoint.open(url, address, handlers);
            case TCP -> TcpServerEndpoint.open(url, address, handlers);
        };
    }

    /** With the port that was really taken. */
    EndpointUrl url();

    EndpointCounters counters();

    @Override
    void close();
}
