package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.util.List;

/** A door for vehicles: one socket or line and the one thread that reads it. */
public interface Endpoint extends AutoCloseable {
    /** Opens the door that the URL names; one that dials fails later, and tries again. The failure's message says what to do. */
    static Endpoint open(EndpointUrl url, PeerHandler.Factory handlers) throws IOException {
        return switch (url.kind()) {
            case UDPSERVER -> UdpServerEndpoint.open(url, handlers);
            case TCPSERVER -> TcpServerEndpoint.open(url, handlers);
            case UDPCLIENT -> new DialledEndpoint(url, UdpLine::dial, handlers).start();
            case TCPCLIENT -> new DialledEndpoint(url, TcpLine::dial, handlers).start();
        };
    }

    /** With the port that was really taken. */
    EndpointUrl url();

    EndpointState state();

    EndpointCounters counters();

    List<PeerStatus> peers();

    @Override
    void close();
}
