package org.dronemap.proxy.endpoint;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.ByteBuffer;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.java_websocket.client.WebSocketClient;
import org.java_websocket.handshake.ServerHandshake;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A WebSocket that the server opened to a vehicle or router. Messages wait in a queue of 64 for the endpoint's thread;
 * while it is full the library does not read on, which holds the other side back.
 */
final class WebSocketConnection implements NetworkConnection {
    private static final Logger LOG = LoggerFactory.getLogger(WebSocketConnection.class);
    private static final int MOST_WAITING = 64;
    private static final int LARGEST_MESSAGE_BYTES = 65_536;
    private static final int PATIENCE_MILLIS = 5_000;

    private final Client client;
    private final WebSocketFrameSender out;
    private final InetSocketAddress remote;
    private @Nullable ByteBuffer rest;

    private WebSocketConnection(Client client, InetSocketAddress remote) {
        this.client = client;
        this.out = new WebSocketFrameSender(client.getConnection());
        this.remote = remote;
    }

    static OutboundConnection dial(EndpointUrl url) throws IOException {
        InetSocketAddress remote = SocketAddresses.resolve(url);
        String path = url.path().isEmpty() ? "/" : url.path();
        String scheme = url.kind() == EndpointUrl.Kind.WSSCLIENT ? "wss://" : "ws://";
        Client client = new Client(URI.create(scheme + url.host() + ":" + url.port() + path));
        try {
            if (!client.connectBlocking(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
                client.close();
                throw new IOException(client.why);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
        return new WebSocketConnection(client, remote);
    }

    @Override
    public InetSocketAddress remote() {
        return remote;
    }

    @Override
    public int read(ByteBuffer into, long patienceMillis) throws IOException {
        ByteBuffer next = rest;
        if (next == null || !next.hasRemaining()) {
            next = pollMessage(patienceMillis);
            rest = next;
        }
        if (next == null) {
            return 0;
        }
        int count = Math.min(next.remaining(), into.remaining());
        ByteBuffer part = next.slice(next.position(), count);
        into.put(part);
        next.position(next.position() + count);
        return count;
    }

    private @Nullable ByteBuffer pollMessage(long patienceMillis) throws IOException {
        try {
            ByteBuffer next = client.waiting.poll(patienceMillis, TimeUnit.MILLISECONDS);
            if (next == null && client.isClosed()) {
                throw new EOFException(client.why);
            }
            return next;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
    }

    @Override
    public boolean send(byte[] frame) {
        return out.send(frame);
    }

    @Override
    public int waiting() {
        return out.waiting();
    }

    @Override
    public void close() {
        client.close();
        // Its reading thread may wait for room.
        client.waiting.clear();
    }

    /** The library's client; its thread only hands messages over. */
    private static final class Client extends WebSocketClient {
        private final ArrayBlockingQueue<ByteBuffer> waiting = new ArrayBlockingQueue<>(MOST_WAITING);
        private volatile String why = "nobody answered within 5 s";

        Client(URI address) {
            super(address, BoundedWebSocketDraft.ofOurChoice(LARGEST_MESSAGE_BYTES), null, PATIENCE_MILLIS);
            setDaemon(true);
            setTcpNoDelay(true);
            setConnectionLostTimeout(20);
        }

        @Override
        public void onOpen(ServerHandshake handshake) {
            LOG.debug("{} is open", getURI());
        }

        @Override
        public void onMessage(String text) {
            LOG.debug("{} sent a text, which is no MAVLink", getURI());
        }

        @Override
        public void onMessage(ByteBuffer bytes) {
            try {
                while (!isClosing() && !isClosed() && !waiting.offer(bytes, 200, TimeUnit.MILLISECONDS)) {
                    LOG.debug("{} is held back", getURI());
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }

        @Override
        public void onClose(int code, String reason, boolean remote) {
            if (!reason.isEmpty()) {
                why = reason;
            } else if (remote) {
                why = "the other side closed the connection";
            }
        }

        @Override
        public void onError(Exception e) {
            why = String.valueOf(e.getMessage());
        }
    }
}
