package org.dronemap.sim.link;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.function.Consumer;

/** The UDP socket of a simulated vehicle towards the server, with a port of its own. One frame a datagram. */
final class SimulatorUdpLink implements SimulatorLink {
    private final InetSocketAddress server;
    private final Selector selector;
    private final ByteBuffer inbound;
    private final ByteBuffer outbound;
    private final Consumer<ByteBuffer> received;
    private DatagramChannel channel;
    private long dropped;

    SimulatorUdpLink(InetSocketAddress server, Selector selector, Buffers buffers, Consumer<ByteBuffer> received)
            throws IOException {
        this.server = server;
        this.selector = selector;
        this.inbound = buffers.inbound();
        this.outbound = buffers.outbound();
        this.received = received;
        this.channel = open();
    }

    private DatagramChannel open() throws IOException {
        DatagramChannel opened = DatagramChannel.open();
        opened.configureBlocking(false);
        opened.connect(server);
        opened.register(selector, SelectionKey.OP_READ, this);
        return opened;
    }

    @Override
    public void send(byte[] bytes) {
        outbound.clear().put(bytes).flip();
        try {
            if (channel.write(outbound) == 0) {
                dropped++;
            }
        } catch (IOException e) {
            // Nobody listens there just now; a vehicle goes on talking.
            dropped++;
        }
    }

    @Override
    public void ready(SelectionKey key) {
        try {
            while (channel.read(inbound.clear()) > 0) {
                received.accept(inbound.flip());
            }
        } catch (PortUnreachableException e) {
            dropped++;
        } catch (IOException e) {
            renew();
        }
    }

    @Override
    public void maintain(long nowNanos) {
        // A UDP socket needs no care.
    }

    @Override
    public void renew() {
        close();
        try {
            channel = open();
        } catch (IOException e) {
            throw new UncheckedIOException("no new UDP port can be had", e);
        }
    }

    @Override
    public void close() {
        try {
            channel.close();
        } catch (IOException e) {
            dropped++;
        }
    }

    @Override
    public long dropped() {
        return dropped;
    }
}
