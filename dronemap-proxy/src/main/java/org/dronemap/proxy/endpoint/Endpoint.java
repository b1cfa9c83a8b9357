package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.util.List;
import java.util.OptionalLong;
import org.dronemap.core.time.Time;

/** A transport that vehicles are met on (a UDP, TCP, DTLS or WebSocket port, or a serial line), with its thread. */
public interface Endpoint extends AutoCloseable {
    /**
     * Opens the door that the URL names; one that dials fails later, and tries again. The failure's message says what to do.
     */
    static Endpoint open(EndpointUrl url, PeerHandler.Factory handlers, EndpointSecurity doors, Time time)
            throws IOException {
        return switch (url.kind()) {
            case UDPSERVER -> UdpServerEndpoint.open(url, handlers, time);
            case TCPSERVER -> TcpServerEndpoint.open(url, handlers, time);
            case UDPCLIENT -> new OutboundEndpoint(url, UdpConnection::dial, handlers, time).start();
            case TCPCLIENT -> new OutboundEndpoint(url, TcpConnection::dial, handlers, time).start();
            case SERIAL -> new OutboundEndpoint(url, at -> SerialConnection.dial(at, time), handlers, time).start();
            case WSSERVER, WSSSERVER -> WebSocketServerEndpoint.open(url, handlers, doors, time);
            case WSCLIENT, WSSCLIENT -> new OutboundEndpoint(url, WebSocketConnection::dial, handlers, time).start();
            case DTLSSERVER -> DtlsServerEndpoint.open(url, handlers, doors.keys(), time);
        };
    }

    /** With the port that was really taken. */
    EndpointUrl url();

    /** A door that listens is open from the start; one that dials says how far it is. */
    default EndpointState state() {
        return EndpointState.OPEN;
    }

    /** Nobody listens here any more although nobody closed it: it has to be closed and opened again. */
    default boolean isOver() {
        return false;
    }

    EndpointCounters counters();

    List<PeerStatus> peers();

    /** Datagrams that the kernel threw away before they could be read; empty where nobody counts them. */
    default OptionalLong kernelDrops() {
        return OptionalLong.empty();
    }

    /** Ends every link that was proven with that identity: its key is no longer good. */
    default void disconnect(String identity) {
        // Most links prove nothing.
    }

    @Override
    void close();
}
