package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One UDP socket for many vehicles; answers leave from the socket that heard. The peer table belongs to its thread. */
final class UdpServerEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(UdpServerEndpoint.class);
    private static final int RECEIVE_BUFFER_BYTES = 4 * 1024 * 1024;
    private static final int LARGEST_DATAGRAM = 65_536;
    private static final int MAX_PEERS = 10_000;
    private static final long IDLE_NANOS = 60_000_000_000L;

    private final EndpointUrl url;
    private final DatagramChannel channel;
    private final PeerHandler.Factory handlers;
    private final EndpointCounters counters = new EndpointCounters();
    private final Thread thread;
    private final Map<SocketAddress, UdpPeer> peers = new LinkedHashMap<>(64, 0.75f, true);

    private UdpServerEndpoint(EndpointUrl url, DatagramChannel channel, PeerHandler.Factory handlers) {
        this.url = url;
        this.channel = channel;
        this.handlers = handlers;
        thread = new Thread(this::run, "udp-" + url.port());
        thread.setDaemon(true);
    }

    static UdpServerEndpoint open(EndpointUrl url, InetSocketAddress address, PeerHandler.Factory handlers)
            throws IOException {
        DatagramChannel channel = DatagramChannel.open();
        try {
            channel.setOption(StandardSocketOptions.SO_RCVBUF, RECEIVE_BUFFER_BYTES);
            channel.bind(address);
        } catch (IOException e) {
            channel.close();
            throw cannotOpen(url, e);
        }
        int port = ((InetSocketAddress) channel.getLocalAddress()).getPort();
        UdpServerEndpoint endpoint = new UdpServerEndpoint(url.withPort(port), channel, handlers);
        int granted = channel.getOption(StandardSocketOptions.SO_RCVBUF);
        if (granted < RECEIVE_BUFFER_BYTES) {
            LOG.info(
                    "{} has a receive buffer of {} kB; net.core.rmem_max of 4194304 would hold bursts of big fleets",
                    endpoint.url,
                    granted / 1024);
        }
        endpoint.thread.start();
        return endpoint;
    }

    static IOException cannotOpen(EndpointUrl url, IOException cause) {
        String why = cause instanceof BindException
                        && String.valueOf(cause.getMessage()).contains("in use")
                ? "port " + url.port() + " is taken by another program; stop it or configure another port."
                : cause.getMessage() + ".";
        return new IOException("Cannot listen on " + url + ": " + why, cause);
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
        ByteBuffer buffer = ByteBuffer.allocateDirect(LARGEST_DATAGRAM);
        while (channel.isOpen()) {
            try {
                buffer.clear();
                SocketAddress from = channel.receive(buffer);
                buffer.flip();
                if (from instanceof InetSocketAddress address) {
                    deliver(address, buffer);
                }
            } catch (ClosedChannelException e) {
                LOG.debug("{} is closed", url);
            } catch (IOException | RuntimeException e) {
                LOG.warn("{} could not take a datagram", url, e);
            }
        }
        peers.values().forEach(peer -> peer.handler.closed());
    }

    private void deliver(InetSocketAddress from, ByteBuffer bytes) {
        long now = System.nanoTime();
        UdpPeer peer = peers.get(from);
        if (peer == null) {
            makeRoom(now);
            if (peers.size() >= MAX_PEERS) {
                counters.refusedPeer();
                return;
            }
            peer = new UdpPeer(from);
            peers.put(from, peer);
            counters.peers(peers.size());
        }
        peer.lastHeardNanos = now;
        peer.handler.received(bytes);
    }

    /** Gives away the places of the longest silent ones, which stand first. */
    private void makeRoom(long now) {
        Iterator<UdpPeer> oldest = peers.values().iterator();
        while (oldest.hasNext()) {
            UdpPeer peer = oldest.next();
            if (now - peer.lastHeardNanos < IDLE_NANOS) {
                return;
            }
            oldest.remove();
            peer.handler.closed();
        }
    }

    @Override
    public void close() {
        try {
            channel.close();
            thread.join(1000);
        } catch (IOException e) {
            LOG.warn("{} did not close cleanly", url, e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private final class UdpPeer implements Peer {
        private final InetSocketAddress address;
        private final PeerHandler handler;
        private long lastHeardNanos;

        UdpPeer(InetSocketAddress address) {
            this.address = address;
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

        @Override
        public void send(byte[] frame) {
            try {
                if (channel.send(ByteBuffer.wrap(frame), address) == frame.length) {
                    counters.sent();
                } else {
                    counters.droppedOut();
                }
            } catch (IOException e) {
                counters.droppedOut();
                LOG.debug("{} could not send to {}", url, address, e);
            }
        }
    }
}
