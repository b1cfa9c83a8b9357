package org.dronemap.proxy.endpoint;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A TCP connection to a vehicle, modem or router that listens. */
final class TcpLine implements NetworkLine {
    private static final Logger LOG = LoggerFactory.getLogger(TcpLine.class);
    private static final int PATIENCE_MILLIS = 5_000;

    private final PatientReader reader;
    private final InetSocketAddress remote;
    private final TcpWire wire;

    private TcpLine(SocketChannel channel, PatientReader reader, InetSocketAddress remote) {
        this.reader = reader;
        this.remote = remote;
        this.wire = new TcpWire(channel);
    }

    static Line dial(EndpointUrl url) throws IOException {
        InetSocketAddress remote = SocketAddresses.resolve(url);
        SocketChannel channel = SocketChannel.open();
        try {
            channel.socket().connect(remote, PATIENCE_MILLIS);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            channel.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
            return new TcpLine(channel, PatientReader.of(channel), remote);
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
