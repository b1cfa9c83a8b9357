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
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One TCP port for a bounded number of vehicles, all read by one selector thread; silent connections are closed. */
final class TcpServerEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(TcpServerEndpoint.class);
    static final int MAX_PEERS = 1_000;
    private static final long IDLE_NANOS = 60_000_000_000L;
    private static final long SELECT_MILLIS = 1_000;

    private final EndpointUrl url;
    private final ServerSocketChannel server;
    private final Selector selector;
    private final PeerHandler.Factory handlers;
    private final EndpointCounters counters = new EndpointCounters();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(65_536);
    private final Thread thread;
    private long lastSweepNanos = System.nanoTime();

    private TcpServerEndpoint(
            EndpointUrl url, ServerSocketChannel server, Selector selector, PeerHandler.Factory handlers) {
        this.url = url;
        this.server = server;
        this.selector = selector;
        this.handlers = handlers;
        thread = new Thread(this::run, "tcp-" + url.port());
        thread.setDaemon(true);
    }

    static TcpServerEndpoint open(EndpointUrl url, InetSocketAddress address, PeerHandler.Factory handlers)
            throws IOException {
        ServerSocketChannel server = ServerSocketChannel.open();
        try {
            server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            server.bind(address);
            server.configureBlocking(false);
        } catch (IOException e) {
            server.close();
            throw UdpServerEndpoint.cannotOpen(url, e);
        }
        Selector selector = Selector.open();
        server.register(selector, SelectionKey.OP_ACCEPT);
        int port = ((InetSocketAddress) server.getLocalAddress()).getPort();
        TcpServerEndpoint endpoint = new TcpServerEndpoint(url.withPort(port), server, selector, handlers);
        endpoint.thread.start();
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

    private void run() {
        while (selector.isOpen()) {
            try {
                selector.select(this::ready, SELECT_MILLIS);
                sweep(System.nanoTime());
            } catch (ClosedSelectorException e) {
                LOG.debug("{} is closed", url);
            } catch (IOException | RuntimeException e) {
                LOG.warn("{} could not serve a connection", url, e);
            }
        }
    }

    private void ready(SelectionKey key) {
        if (!key.isValid()) {
            return;
        }
        if (key.isAcceptable()) {
            accept();
        } else if (key.attachment() instanceof TcpPeer peer) {
            read(peer);
        }
    }

    private void accept() {
        try {
            SocketChannel channel = server.accept();
            if (channel == null) {
                return;
            }
            if (peerCount() >= MAX_PEERS) {
                counters.refusedPeer();
                channel.close();
                return;
            }
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            SelectionKey key = channel.register(selector, SelectionKey.OP_READ);
            TcpPeer peer = new TcpPeer(channel, (InetSocketAddress) channel.getRemoteAddress(), key);
            key.attach(peer);
            counters.peers(peerCount());
        } catch (IOException e) {
            LOG.warn("{} could not accept a connection", url, e);
        }
    }

    private void read(TcpPeer peer) {
        try {
            buffer.clear();
            int count = peer.channel.read(buffer);
            if (count < 0) {
                drop(peer, "it closed the connection");
                return;
            }
            peer.lastHeardNanos = System.nanoTime();
            buffer.flip();
            peer.handler.received(buffer);
        } catch (IOException e) {
            drop(peer, String.valueOf(e.getMessage()));
        }
    }

    private void sweep(long now) {
        if (now - lastSweepNanos < SELECT_MILLIS * 1_000_000) {
            return;
        }
        lastSweepNanos = now;
        for (SelectionKey key : List.copyOf(selector.keys())) {
            if (key.attachment() instanceof TcpPeer peer) {
                if (!peer.channel.isOpen()) {
                    drop(peer, "sending failed");
                } else if (now - peer.lastHeardNanos > IDLE_NANOS) {
                    drop(peer, "silent for a minute");
                }
            }
        }
        counters.peers(peerCount());
    }

    private int peerCount() {
        return (int) selector.keys().stream()
                .filter(key -> key.isValid() && key.attachment() instanceof TcpPeer)
                .count();
    }

    private void drop(TcpPeer peer, String why) {
        LOG.info("{} lost its peer {}: {}", url, peer.address, why);
        peer.key.cancel();
        peer.closeQuietly();
        if (!peer.told) {
            peer.told = true;
            peer.handler.closed();
        }
        counters.peers(peerCount());
    }

    @Override
    public void close() {
        try {
            server.close();
            for (SelectionKey key : List.copyOf(selector.keys())) {
                if (key.attachment() instanceof TcpPeer peer) {
                    peer.closeQuietly();
                }
            }
            selector.close();
            thread.join(1000);
        } catch (IOException e) {
            LOG.warn("{} did not close cleanly", url, e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private final class TcpPeer implements Peer {
        private final SocketChannel channel;
        private final InetSocketAddress address;
        private final SelectionKey key;
        private final PeerHandler handler;
        private volatile long lastHeardNanos = System.nanoTime();
        private boolean told;

        TcpPeer(SocketChannel channel, InetSocketAddress address, SelectionKey key) {
            this.channel = channel;
            this.address = address;
            this.key = key;
            this.handler = handlers.opened(this, counters);
        }

        @Override
        public InetSocketAddress address() {
            return address;
        }

        @Override
        public String transport() {
            return url.transport().label();
        }

        /** A peer that does not read loses its connection: half a frame in its stream would harm the next ones. */
        @Override
        public synchronized void send(byte[] frame) {
            try {
                ByteBuffer bytes = ByteBuffer.wrap(frame);
                channel.write(bytes);
                if (!bytes.hasRemaining()) {
                    counters.sent();
                    return;
                }
                counters.droppedOut();
                if (bytes.position() > 0) {
                    closeQuietly();
                }
            } catch (IOException e) {
                counters.droppedOut();
                closeQuietly();
            }
        }

        private void closeQuietly() {
            try {
                channel.close();
            } catch (IOException e) {
                LOG.debug("{} could not close the connection to {}", url, address, e);
            }
        }
    }
}
