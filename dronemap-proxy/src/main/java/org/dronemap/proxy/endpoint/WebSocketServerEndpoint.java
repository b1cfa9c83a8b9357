package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import org.dronemap.core.time.FatalErrors;
import org.dronemap.core.time.Time;
import org.java_websocket.WebSocket;
import org.java_websocket.drafts.Draft;
import org.java_websocket.exceptions.InvalidDataException;
import org.java_websocket.framing.CloseFrame;
import org.java_websocket.handshake.ClientHandshake;
import org.java_websocket.handshake.ServerHandshakeBuilder;
import org.java_websocket.server.WebSocketServer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A WebSocket port for a bounded number of vehicles or robots, which send binary frames or texts. Browsers are turned
 * away, so that no web page can play a vehicle to a server on its visitor's machine.
 */
final class WebSocketServerEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(WebSocketServerEndpoint.class);
    private static final PeerRegistry.Limits LIMITS = new PeerRegistry.Limits(2_000, 1_000);
    private static final Duration LONGEST_OPENING = Duration.ofSeconds(10);

    private final EndpointUrl url;
    private final EndpointCounters counters = new EndpointCounters();
    private final PeerRegistry<WebSocket> peers;
    private final PeerHandler.Factory handlers;
    private final Server server;
    private final Time time;
    private int port;
    private volatile boolean closed;
    private volatile boolean over;

    private WebSocketServerEndpoint(
            EndpointUrl url,
            InetSocketAddress address,
            PeerHandler.Factory handlers,
            EndpointSecurity doors,
            Time time) {
        this.url = url;
        this.handlers = handlers;
        this.time = time;
        peers = new PeerRegistry<>(counters, handlers, LIMITS, time);
        boolean encrypted = url.kind() == EndpointUrl.Kind.WSSSERVER;
        BoundedWebSocketFactory door = new BoundedWebSocketFactory(
                doors.limits(), encrypted ? doors.tls() : () -> null, counters::refusedPeer, time);
        server = new Server(address, new EndpointPeer.Origin(url, SocketAddresses.isLocal(address), false), door);
    }

    static WebSocketServerEndpoint open(
            EndpointUrl url, PeerHandler.Factory handlers, EndpointSecurity doors, Time time) throws IOException {
        if (url.kind() == EndpointUrl.Kind.WSSSERVER && doors.tls().get() == null) {
            throw new IOException("Cannot listen on " + url
                    + ": the server has no certificate; give it one (DRONEMAP_TLS_CERT, DRONEMAP_TLS_KEY).");
        }
        WebSocketServerEndpoint endpoint =
                new WebSocketServerEndpoint(url, SocketAddresses.resolve(url), handlers, doors, time);
        endpoint.start();
        return endpoint;
    }

    private void start() throws IOException {
        server.start();
        try {
            port = time.await(server.listening, LONGEST_OPENING);
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            throw SocketAddresses.cannotListen(url, cause instanceof IOException io ? io : new IOException(cause));
        } catch (TimeoutException e) {
            close();
            throw new IOException(
                    "Cannot listen on " + url + ": it took more than " + LONGEST_OPENING.toSeconds() + " s.", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("Interrupted while opening " + url + ".", e);
        }
    }

    @Override
    public EndpointUrl url() {
        return url.withPort(port);
    }

    @Override
    public boolean isOver() {
        return over;
    }

    @Override
    public EndpointCounters counters() {
        return counters;
    }

    @Override
    public List<PeerStatus> peers() {
        return peers.status();
    }

    @Override
    public void close() {
        closed = true;
        // Told first: the library's thread goes some 25 ms after stop() began, and who is told later breaks the rest of
        // it.
        server.getConnections().forEach(socket -> socket.close(CloseFrame.GOING_AWAY));
        try {
            server.stop(1_000);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (ClosedSelectorException e) {
            LOG.debug("{}: somebody came while it closed, and was not told", url, e);
        }
        peers.clear();
    }

    /** The library's server; with one worker all peers are served by one thread. */
    private final class Server extends WebSocketServer {
        private final EndpointPeer.Origin place;
        private final CompletableFuture<Integer> listening = new CompletableFuture<>();

        Server(InetSocketAddress address, EndpointPeer.Origin place, BoundedWebSocketFactory door) {
            super(
                    address,
                    1,
                    List.<Draft>of(new BoundedWebSocketDraft(handlers.speech().longestMessage())));
            this.place = place;
            setWebSocketFactory(door);
            setReuseAddr(true);
            setTcpNoDelay(true);
            setDaemon(true);
            setConnectionLostTimeout(30);
        }

        @Override
        public void run() {
            try {
                super.run();
            } catch (ThreadDeath e) {
                // What was lost with it is this door alone.
                LOG.error("The thread of {} was stopped", url, e);
            } finally {
                over = !closed;
            }
        }

        @Override
        public ServerHandshakeBuilder onWebsocketHandshakeReceivedAsServer(
                WebSocket socket, Draft draft, ClientHandshake request) throws InvalidDataException {
            if (!request.getFieldValue("Origin").isEmpty()) {
                counters.refusedPeer();
                throw new InvalidDataException(CloseFrame.POLICY_VALIDATION, "vehicles only, no web pages");
            }
            if (!handlers.acceptsPath(request.getResourceDescriptor())) {
                counters.refusedPeer();
                throw new InvalidDataException(CloseFrame.POLICY_VALIDATION, "nobody is to be found on this path");
            }
            return super.onWebsocketHandshakeReceivedAsServer(socket, draft, request);
        }

        @Override
        public void onOpen(WebSocket socket, ClientHandshake handshake) {
            InetSocketAddress remote = socket.getRemoteSocketAddress();
            if (remote == null) {
                return;
            }
            PeerAddress address = PeerAddress.of(remote);
            WebSocketFrameSender queue =
                    new WebSocketFrameSender(socket, handlers.speech().text());
            EndpointPeer.Origin at = place.at(handshake.getResourceDescriptor());
            EndpointPeer seat = peers.add(
                    socket, address.host(), time.nanos(), welcome -> new EndpointPeer(at, address, queue, welcome));
            if (seat == null) {
                socket.close(CloseFrame.TRY_AGAIN_LATER, "there is no room for more vehicles");
            }
        }

        @Override
        public void onMessage(WebSocket socket, ByteBuffer bytes) {
            EndpointPeer seat = peers.find(socket);
            long now = time.nanos();
            if (seat != null) {
                seat.received(bytes, now);
                if (!seat.isStranger()) {
                    BoundedWebSocketDraft.admit(socket);
                }
            }
            peers.sweep(now);
        }

        @Override
        public void onMessage(WebSocket socket, String text) {
            if (handlers.speech().text()) {
                onMessage(socket, ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
            } else {
                socket.close(CloseFrame.REFUSE, "send MAVLink frames in binary messages");
            }
        }

        @Override
        public void onClose(WebSocket socket, int code, String reason, boolean remote) {
            peers.remove(socket);
        }

        @Override
        public void onError(@Nullable WebSocket socket, Exception e) {
            FatalErrors.reportCause(e);
            if (socket != null) {
                LOG.debug("{}: a connection broke", url, e);
            } else if (!listening.completeExceptionally(e)) {
                LOG.error("{} failed", url, e);
            }
        }

        @Override
        public void onStart() {
            listening.complete(getPort());
        }
    }
}
