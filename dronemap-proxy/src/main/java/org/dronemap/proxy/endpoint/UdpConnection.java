package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A UDP socket connected to one configured address, which it sends to and receives from. */
final class UdpConnection implements NetworkConnection {
    private static final Logger LOG = LoggerFactory.getLogger(UdpConnection.class);
    private static final int RECEIVE_BUFFER_BYTES = 4 * 1024 * 1024;

    private final DatagramChannel channel;
    private final TimedChannelReader reader;
    private final InetSocketAddress remote;

    private UdpConnection(DatagramChannel channel, TimedChannelReader reader, InetSocketAddress remote) {
        this.channel = channel;
        this.reader = reader;
        this.remote = remote;
    }

    static OutboundConnection dial(EndpointUrl url) throws IOException {
        InetSocketAddress remote = SocketAddresses.resolve(url);
        DatagramChannel channel = DatagramChannel.open();
        try {
            channel.setOption(StandardSocketOptions.SO_RCVBUF, RECEIVE_BUFFER_BYTES);
            channel.connect(remote);
            return new UdpConnection(channel, TimedChannelReader.of(channel), remote);
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
        try {
            return reader.read(into, patienceMillis);
        } catch (PortUnreachableException e) {
            // Nobody listens there just now; somebody may tomorrow.
            LOG.debug("{} does not listen", remote, e);
            return 0;
        }
    }

    @Override
    public boolean send(byte[] frame) {
        try {
            return channel.write(ByteBuffer.wrap(frame)) == frame.length;
        } catch (IOException e) {
            LOG.debug("{} does not take a datagram", remote, e);
            return false;
        }
    }

    @Override
    public void close() {
        try {
            channel.close();
            reader.close();
        } catch (IOException e) {
            LOG.debug("The socket to {} did not close cleanly", remote, e);
        }
    }
}
