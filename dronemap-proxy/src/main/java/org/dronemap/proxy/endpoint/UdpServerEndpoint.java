package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.List;
import java.util.OptionalLong;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.WaitStrategy;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A UDP port that any number of vehicles send to; replies leave from the same port. */
final class UdpServerEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(UdpServerEndpoint.class);
    private static final int RECEIVE_BUFFER_BYTES = 4 * 1024 * 1024;
    private static final int INTAKE_BYTES = 4 * 1024 * 1024;
    private static final int INTAKE_DATAGRAMS = 65_536;
    private static final int BETWEEN_REFILLS = 64;

    private final EndpointUrl url;
    private final DatagramChannel channel;
    private final Selector selector;
    private final EndpointCounters counters = new EndpointCounters();
    private final DatagramPeers<InetSocketAddress> peers;
    private final DatagramQueue intake;
    private volatile boolean closed;
    private volatile boolean over;
    private @Nullable Thread thread;

    private UdpServerEndpoint(
            EndpointUrl url, DatagramChannel channel, Selector selector, PeerHandler.Factory handlers, Time time)
            throws IOException {
        InetSocketAddress bound = (InetSocketAddress) channel.getLocalAddress();
        this.url = url.withPort(bound.getPort());
        this.channel = channel;
        this.selector = selector;
        intake = new DatagramQueue(
                INTAKE_BYTES, INTAKE_DATAGRAMS, handlers.speech().longestDatagram());
        EndpointPeer.Origin place = new EndpointPeer.Origin(this.url, SocketAddresses.isLocal(bound), true);
        peers = new DatagramPeers<>(
                counters, handlers, new DatagramPeers.Outbound<>(place, PeerAddress::of, this::send), time);
    }

    static UdpServerEndpoint open(EndpointUrl url, PeerHandler.Factory handlers, Time time) throws IOException {
        InetSocketAddress address = SocketAddresses.resolve(url);
        DatagramChannel channel = DatagramChannel.open();
        UdpServerEndpoint endpoint;
        try {
            channel.setOption(StandardSocketOptions.SO_RCVBUF, RECEIVE_BUFFER_BYTES);
            channel.bind(address);
            channel.configureBlocking(false);
            endpoint = new UdpServerEndpoint(url, channel, Selector.open(), handlers, time);
        } catch (IOException e) {
            channel.close();
            throw SocketAddresses.cannotListen(url, e);
        }
        int granted = channel.getOption(StandardSocketOptions.SO_RCVBUF);
        if (granted < RECEIVE_BUFFER_BYTES) {
            LOG.warn(
                    "{} got a receive buffer of {} kB, not the 4096 kB asked for: bursts of a big fleet may be lost;"
                            + " set net.core.rmem_max to 4194304 or more.",
                    endpoint.url,
                    granted / 1024);
        }
        endpoint.thread = time.blocking("udp-" + endpoint.url.port(), endpoint::run);
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
        WaitStrategy rhythm = new WaitStrategy();
        try (selector) {
            channel.register(selector, SelectionKey.OP_READ);
            while (channel.isOpen()) {
                rhythm.pause(readAll(), () -> selector.select(ready -> {}));
            }
        } catch (ClosedChannelException e) {
            LOG.debug("{} is closed", url);
        } catch (IOException e) {
            LOG.error("{} cannot wait for datagrams any more", url, e);
        }
        peers.clear();
    }

    /** Works on all that is there; false when there was nothing. */
    private boolean readAll() throws ClosedChannelException {
        refill();
        boolean any = intake.waiting() > 0;
        while (intake.waiting() > 0) {
            int count = 0;
            while (count < BETWEEN_REFILLS && intake.process(this::deliver)) {
                count++;
            }
            refill();
        }
        return any;
    }

    private void refill() throws ClosedChannelException {
        try {
            intake.readFrom(channel);
        } catch (ClosedChannelException e) {
            throw e;
        } catch (IOException e) {
            LOG.warn("{} could not take a datagram", url, e);
        }
    }

    private void deliver(InetSocketAddress from, ByteBuffer bytes) {
        try {
            peers.deliver(from, bytes);
        } catch (RuntimeException e) {
            LOG.warn("{} could not work on a datagram of {}", url, from, e);
        }
    }

    private boolean send(InetSocketAddress to, byte[] frame) {
        try {
            return channel.send(ByteBuffer.wrap(frame), to) == frame.length;
        } catch (IOException e) {
            LOG.debug("{} could not send to {}", url, to, e);
            return false;
        }
    }

    @Override
    public void close() {
        closed = true;
        try {
            channel.close();
            selector.wakeup();
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
