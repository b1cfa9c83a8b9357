package org.dronemap.proxy.endpoint;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A TCP connection that the server opened to a vehicle, modem or router that listens. */
final class TcpConnection implements NetworkConnection {
    private static final Logger LOG = LoggerFactory.getLogger(TcpConnection.class);
    private static final int PATIENCE_MILLIS = 5_000;

    private final TimedChannelReader reader;
    private final InetSocketAddress remote;
    private final TcpFrameSender wire;

    private TcpConnection(SocketChannel channel, TimedChannelReader reader, InetSocketAddress remote) {
        this.reader = reader;
        this.remote = remote;
        this.wire = new TcpFrameSender(channel);
    }

    static OutboundConnection dial(EndpointUrl url) throws IOException {
        InetSocketAddress remote = SocketAddresses.resolve(url);
        SocketChannel channel = SocketChannel.open();
        try {
            channel.socket().connect(remote, PATIENCE_MILLIS);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            channel.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
            return new TcpConnection(channel, TimedChannelReader.of(channel), remote);
        } catch (IOException e) {
            channel.close();
            throw e;
        }
    }

    @Override
    public InetSocketAddress remote() {
        return remote;
    }

    @Override
    public int read(ByteBuffer into, long patienceMillis) throws IOException {
        int count = reader.read(into, patienceMillis);
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
            reader.close();
        } catch (IOException e) {
            LOG.debug("The connection to {} did not close cleanly", remote, e);
        }
    }
}
