package org.dronemap.proxy.endpoint;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A TCP connection to a vehicle, modem or router that listens. */
final class TcpLine implements Line {
    private static final Logger LOG = LoggerFactory.getLogger(TcpLine.class);
    private static final int PATIENCE_MILLIS = 5_000;

    private final SocketChannel channel;
    private final Selector selector;
    private final InetSocketAddress remote;
    private final TcpWire wire;

    private TcpLine(SocketChannel channel, Selector selector, InetSocketAddress remote) {
        this.channel = channel;
        this.selector = selector;
        this.remote = remote;
        this.wire = new TcpWire(channel);
    }

    static Line dial(EndpointUrl url) throws IOException {
        InetSocketAddress remote = SocketAddresses.resolve(url);
        SocketChannel channel = SocketChannel.open();
        try {
            channel.socket().connect(remote, PATIENCE_MILLIS);
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            channel.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
            Selector selector = Selector.open();
            channel.register(selector, SelectionKey.OP_READ);
            return new TcpLine(channel, selector, remote);
        } catch (IOException e) {
            channel.close();
            throw e;
        }
    }

    @Override
    public PeerAddress address() {
        return PeerAddress.of(remote);
    }

    @Override
    public boolean isLocal() {
        return SocketAddresses.isLocal(remote);
    }

    @Override
    public int read(ByteBuffer into, long patienceMillis) throws IOException {
        int count = channel.read(into);
        if (count == 0) {
            selector.select(patienceMillis);
            selector.selectedKeys().clear();
            count = channel.read(into);
        }
        if (count < 0) {
            throw new EOFException("the other side closed the connection");
        }
        return count;
    }

    @Override
    public boolean send(byte[] frame) {
        return wire.send(frame);
    }

    @Override
    public void close() {
        wire.close();
        try {
            selector.close();
        } catch (IOException e) {
            LOG.debug("The connection to {} did not close cleanly", remote, e);
        }
    }
}
