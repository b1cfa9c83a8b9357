package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sends frames to one peer over a non-blocking TCP connection, and drops those that find no room. The rest of a frame
 * that went half waits for the next one, so that the stream never breaks; frames that find no room are dropped. That
 * the connection failed is noticed by its reader.
 */
final class TcpFrameSender implements FrameSender {
    private static final Logger LOG = LoggerFactory.getLogger(TcpFrameSender.class);

    private final SocketChannel channel;
    // guarded by this
    private ByteBuffer rest = ByteBuffer.allocate(0);

    TcpFrameSender(SocketChannel channel) {
        this.channel = channel;
    }

    @Override
    public synchronized boolean send(byte[] frame) {
        try {
            if (rest.hasRemaining()) {
                channel.write(rest);
            }
            if (rest.hasRemaining()) {
                return false;
            }
            ByteBuffer bytes = ByteBuffer.wrap(frame);
            channel.write(bytes);
            if (bytes.hasRemaining() && bytes.position() > 0) {
                rest = bytes;
                return true;
            }
            return !bytes.hasRemaining();
        } catch (IOException e) {
            LOG.debug("A connection takes no more", e);
            return false;
        }
    }

    @Override
    public void close() {
        try {
            channel.close();
        } catch (IOException e) {
            LOG.debug("A connection did not close cleanly", e);
        }
    }
}
