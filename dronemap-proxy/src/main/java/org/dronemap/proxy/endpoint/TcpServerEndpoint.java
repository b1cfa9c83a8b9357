package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A TCP port that accepts a bounded number of vehicles, all read by one thread; silent connections are closed. A peer
 * that makes too much work is read later, which holds it back and loses nothing.
 */
final class TcpServerEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(TcpServerEndpoint.class);
    private static final PeerRegistry.Limits LIMITS = new PeerRegistry.Limits(2_000, 1_000);
    private static final int BYTES_A_TURN = 16_384;
    private static final long SELECT_MILLIS = 1_000;
    private static final long HELD_BACK_MILLIS = 10;

    private final EndpointUrl url;
    private final ServerSocketChannel server;
    private final Selector selector;
    private final EndpointPeer.Origin place;
    private final EndpointCounters counters = new EndpointCounters();
    private final PeerRegistry<SelectionKey> peers;
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BYTES_A_TURN);
    private final List<SelectionKey> heldBack = new ArrayList<>();
    private final Time time;
    private volatile boolean closed;
    private volatile boolean over;
    private @Nullable Thread thread;

    private TcpServerEndpoint(
            EndpointUrl url, ServerSocketChannel server, Selector selector, PeerHandler.Factory handlers, Time time)
            throws IOException {
        InetSocketAddress bound = (InetSocketAddress) server.getLocalAddress();
        this.url = url.withPort(bound.getPort());
        this.server = server;
        this.selector = selector;
        place = new EndpointPeer.Origin(url, SocketAddresses.isLocal(bound), false);
        peers = new PeerRegistry<>(counters, handlers, LIMITS, time);
        this.time = time;
    }

    static TcpServerEndpoint open(EndpointUrl url, PeerHandler.Factory handlers, Time time) throws IOException {
        InetSocketAddress address = SocketAddresses.resolve(url);
        ServerSocketChannel server = ServerSocketChannel.open();
        try {
            server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            server.bind(address);
            server.configureBlocking(false);
        } catch (IOException e) {
            server.close();
            throw SocketAddresses.cannotListen(url, e);
        }
        Selector selector = Selector.open();
        server.register(selector, SelectionKey.OP_ACCEPT);
        TcpServerEndpoint endpoint = new TcpServerEndpoint(url, server, selector, handlers, time);
        endpoint.thread = time.blocking("tcp-" + endpoint.url.port(), endpoint::run);
        return endpoint;
    }

    @Override
    public EndpointUrl url() {
        return url;
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
    public boolean isOver() {
        return over;
    }

    private void run() {
        try {
            serve();
        } catch (ThreadDeath e) {
            // What was lost with it is this door alone.
            LOG.error("The thread of {} was stopped", url, e);
        } finally {
            over = !closed;
        }
    }

    private void serve() {
        while (selector.isOpen()) {
            try {
                selector.select(this::ready, heldBack.isEmpty() ? SELECT_MILLIS : HELD_BACK_MILLIS);
                long now = time.nanos();
                resumePeers(now);
                peers.sweep(now);
            } catch (ClosedSelectorException e) {
                LOG.debug("{} is closed", url);
            } catch (IOException | RuntimeException e) {
                LOG.warn("{} could not serve a connection", url, e);
            }
        }
        peers.clear();
    }

    private void resumePeers(long now) {
        heldBack.removeIf(key -> {
            EndpointPeer seat = peers.find(key);
            if (seat == null || !key.isValid()) {
                return true;
            }
            boolean goesOn = seat.isWithinBudget(now);
            if (goesOn) {
                key.interestOps(SelectionKey.OP_READ);
            }
            return goesOn;
        });
    }

    private void ready(SelectionKey key) {
        if (!key.isValid()) {
            return;
        }
        if (key.isAcceptable()) {
            accept();
            return;
        }
        EndpointPeer seat = peers.find(key);
        if (seat != null && key.channel() instanceof SocketChannel channel) {
            read(key, channel, seat);
        }
    }

    private void accept() {
        try {
            SocketChannel channel = server.accept();
            if (channel == null) {
                return;
            }
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            SelectionKey key = channel.register(selector, SelectionKey.OP_READ);
            PeerAddress address = PeerAddress.of((InetSocketAddress) channel.getRemoteAddress());
            TcpFrameSender wire = new TcpFrameSender(channel);
            EndpointPeer seat = peers.add(
                    key, address.host(), time.nanos(), welcome -> new EndpointPeer(place, address, wire, welcome));
            if (seat == null) {
                channel.close();
            }
        } catch (IOException e) {
            LOG.warn("{} could not accept a connection", url, e);
        }
    }

    private void read(SelectionKey key, SocketChannel channel, EndpointPeer seat) {
        long now = time.nanos();
        if (!seat.isWithinBudget(now)) {
            key.interestOps(0);
            heldBack.add(key);
            return;
        }
        try {
            buffer.clear();
            int count = channel.read(buffer);
            if (count < 0) {
                drop(key, seat, "it closed the connection");
                return;
            }
            buffer.flip();
            seat.received(buffer, now);
        } catch (IOException e) {
            drop(key, seat, String.valueOf(e.getMessage()));
        }
    }

    private void drop(SelectionKey key, EndpointPeer seat, String why) {
        LOG.info("{} lost its peer {}: {}", url, seat.address(), why);
        key.cancel();
        peers.remove(key);
    }

    @Override
    public void close() {
        closed = true;
        try {
            server.close();
            for (SelectionKey key : List.copyOf(selector.keys())) {
                key.channel().close();
            }
            selector.close();
            if (thread != null) {
                thread.join(1000);
            }
        } catch (IOException e) {
            LOG.warn("{} did not close cleanly", url, e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
