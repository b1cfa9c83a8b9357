package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.util.List;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One UDP socket for many vehicles; answers leave from the socket that heard. */
final class UdpServerEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(UdpServerEndpoint.class);
    private static final PeerBook.Limits LIMITS = new PeerBook.Limits(10_000, 2_500);
    private static final int RECEIVE_BUFFER_BYTES = 4 * 1024 * 1024;
    /** A jumbo frame's worth; what is longer is cut, and counted as broken. */
    private static final int LARGEST_DATAGRAM = 9_000;

    private final EndpointUrl url;
    private final DatagramChannel channel;
    private final EndpointCounters counters = new EndpointCounters();
    private final PeerBook<SocketAddress> peers;
    private final Seat.Place place;
    private final Thread thread;

    private UdpServerEndpoint(
            EndpointUrl url, DatagramChannel channel, InetSocketAddress bound, PeerHandler.Factory handlers) {
        this.url = url;
        this.channel = channel;
        peers = new PeerBook<>(counters, handlers, LIMITS);
        place = new Seat.Place(url, SocketAddresses.isLocal(bound), true);
        thread = new Thread(this::run, "udp-" + url.port());
        thread.setDaemon(true);
    }

    static UdpServerEndpoint open(EndpointUrl url, PeerHandler.Factory handlers) throws IOException {
        InetSocketAddress address = SocketAddresses.resolve(url);
        DatagramChannel channel = DatagramChannel.open();
        try {
            channel.setOption(StandardSocketOptions.SO_RCVBUF, RECEIVE_BUFFER_BYTES);
            channel.bind(address);
        } catch (IOException e) {
            channel.close();
            throw SocketAddresses.cannotListen(url, e);
        }
        InetSocketAddress bound = (InetSocketAddress) channel.getLocalAddress();
        UdpServerEndpoint endpoint = new UdpServerEndpoint(url.withPort(bound.getPort()), channel, bound, handlers);
        int granted = channel.getOption(StandardSocketOptions.SO_RCVBUF);
        if (granted < RECEIVE_BUFFER_BYTES) {
            LOG.warn(
                    "{} got a receive buffer of {} kB, not the 4096 kB asked for: bursts of a big fleet may be lost;"
                            + " set net.core.rmem_max to 4194304 or more.",
                    endpoint.url,
                    granted / 1024);
        }
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

    @Override
    public List<PeerStatus> peers() {
        return peers.status();
    }

    @Override
    public OptionalLong kernelDrops() {
        return KernelDrops.of(url.port());
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
        peers.clear();
    }

    private void deliver(InetSocketAddress from, ByteBuffer bytes) {
        long now = System.nanoTime();
        Seat seat = peers.find(from);
        if (seat == null) {
            seat = welcome(from, now);
        }
        if (seat != null) {
            seat.received(bytes, now);
        }
        peers.sweep(now);
    }

    private @Nullable Seat welcome(InetSocketAddress from, long now) {
        PeerAddress address = PeerAddress.of(from);
        return peers.add(
                from, address.host(), now, welcome -> new Seat(place, address, frame -> send(frame, from), welcome));
    }

    private boolean send(byte[] frame, InetSocketAddress to) {
        try {
            return channel.send(ByteBuffer.wrap(frame), to) == frame.length;
        } catch (IOException e) {
            LOG.debug("{} could not send to {}", url, to, e);
            return false;
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
}
