package org.dronemap.sim.link;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * The TCP connection of a simulated vehicle to the server; reconnects by itself, once a second. What the socket does
 * not take waits in 64 kB; frames beyond that are dropped and counted.
 */
final class SimulatorTcpLink implements SimulatorLink {
    private static final int BACKLOG_BYTES = 65_536;
    private static final long RETRY_NANOS = 1_000_000_000L;

    private final InetSocketAddress server;
    private final Selector selector;
    private final ByteBuffer inbound;
    private final Consumer<ByteBuffer> received;
    private final ByteBuffer backlog = ByteBuffer.allocate(BACKLOG_BYTES);
    private @Nullable SocketChannel channel;
    private long triedAt = Long.MIN_VALUE;
    private long dropped;

    SimulatorTcpLink(InetSocketAddress server, Selector selector, Buffers buffers, Consumer<ByteBuffer> received) {
        this.server = server;
        this.selector = selector;
        this.inbound = buffers.inbound();
        this.received = received;
    }

    @Override
    public void maintain(long nowNanos) {
        if (channel != null || (triedAt != Long.MIN_VALUE && nowNanos - triedAt < RETRY_NANOS)) {
            return;
        }
        triedAt = nowNanos;
        try {
            SocketChannel opened = SocketChannel.open();
            channel = opened;
            opened.configureBlocking(false);
            opened.socket().setTcpNoDelay(true);
            opened.register(selector, SelectionKey.OP_CONNECT, this);
            if (opened.connect(server)) {
                listen(opened);
            }
        } catch (IOException e) {
            close();
        }
    }

    private void listen(SocketChannel opened) {
        opened.keyFor(selector).interestOps(SelectionKey.OP_READ);
    }

    @Override
    public void ready(SelectionKey key) {
        SocketChannel open = channel;
        if (open == null || key.channel() != open) {
            return;
        }
        try {
            if (key.isConnectable()) {
                open.finishConnect();
                listen(open);
            }
            if (key.isWritable()) {
                flush(open);
            }
            if (key.isReadable()) {
                read(open);
            }
        } catch (IOException e) {
            close();
        }
    }

    private void read(SocketChannel open) throws IOException {
        int count;
        while ((count = open.read(inbound.clear())) > 0) {
            received.accept(inbound.flip());
        }
        if (count < 0) {
            close();
        }
    }

    @Override
    public void send(byte[] bytes) {
        SocketChannel open = channel;
        if (open == null || !open.isConnected() || backlog.remaining() < bytes.length) {
            dropped++;
            return;
        }
        backlog.put(bytes);
        try {
            flush(open);
        } catch (IOException e) {
            close();
        }
    }

    private void flush(SocketChannel open) throws IOException {
        backlog.flip();
        open.write(backlog);
        boolean more = backlog.hasRemaining();
        backlog.compact();
        open.keyFor(selector).interestOps(more ? SelectionKey.OP_READ | SelectionKey.OP_WRITE : SelectionKey.OP_READ);
    }

    @Override
    public void renew() {
        close();
        triedAt = Long.MIN_VALUE;
    }

    @Override
    public void close() {
        SocketChannel open = channel;
        channel = null;
        backlog.clear();
        if (open != null) {
            try {
                open.close();
            } catch (IOException e) {
                dropped++;
            }
        }
    }

    @Override
    public long dropped() {
        return dropped;
    }
}
