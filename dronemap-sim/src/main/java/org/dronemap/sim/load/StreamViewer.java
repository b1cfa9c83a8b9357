package org.dronemap.sim.load;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Random;

/** Load test: one connection to the state stream whose messages are only counted. Not thread-safe. */
final class StreamViewer {
    private static final int BUFFER_BYTES = 32 * 1024;
    private static final int TEXT = 1;
    private static final int CLOSE = 8;
    /** Masked by zeros and without content; it keeps a server from taking the viewer for gone. */
    private static final byte[] PONG = {(byte) 0x8A, (byte) 0x80, 0, 0, 0, 0};

    private final SocketChannel channel = SocketChannel.open();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER_BYTES);
    private long skip;
    private long messages;

    StreamViewer(int port, String key) throws IOException {
        channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
        channel.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
        byte[] nonce = new byte[16];
        new Random().nextBytes(nonce);
        channel.write(ByteBuffer.wrap(("GET /stream HTTP/1.1\r\nHost: 127.0.0.1:" + port + "\r\nUpgrade: websocket\r\n"
                        + "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: "
                        + Base64.getEncoder().encodeToString(nonce) + "\r\nAuthorization: Bearer " + key
                        + "\r\n\r\n")
                .getBytes(StandardCharsets.US_ASCII)));
        StringBuilder answer = new StringBuilder();
        buffer.limit(1);
        while (answer.indexOf("\r\n\r\n") < 0) {
            if (channel.read(buffer) < 0) {
                throw new EOFException("The stream ended the connection: " + answer);
            }
            answer.append((char) buffer.get(0));
            buffer.rewind();
        }
        buffer.clear();
        if (!answer.toString().startsWith("HTTP/1.1 101")) {
            throw new IOException("The stream refused: " + answer.toString().split("\r\n", 2)[0]);
        }
    }

    void register(Selector selector) throws IOException {
        channel.configureBlocking(false);
        channel.register(selector, SelectionKey.OP_READ, this);
    }

    long messages() {
        return messages;
    }

    void pong() throws IOException {
        channel.write(ByteBuffer.wrap(PONG));
    }

    void close() throws IOException {
        channel.close();
    }

    /** Once, so that no viewer keeps the others waiting. */
    void read() throws IOException {
        if (channel.read(buffer) < 0) {
            throw new EOFException("The stream ended a connection");
        }
        buffer.flip();
        while (next()) {
            // Each frame that is there.
        }
        buffer.compact();
    }

    /** Whether there was a whole head of a frame, or more of a content to go past. */
    private boolean next() throws IOException {
        if (skip > 0) {
            int here = (int) Math.min(skip, buffer.remaining());
            buffer.position(buffer.position() + here);
            skip -= here;
            return here > 0;
        }
        if (buffer.remaining() < 2) {
            return false;
        }
        int at = buffer.position();
        int length = buffer.get(at + 1) & 0x7F;
        int head = length < 126 ? 2 : length == 126 ? 4 : 10;
        if (buffer.remaining() < head) {
            return false;
        }
        int kind = buffer.get(at) & 0x0F;
        if (kind == CLOSE) {
            throw new EOFException("The stream closed a connection");
        }
        messages += kind == TEXT ? 1 : 0;
        skip = length < 126 ? length : length == 126 ? buffer.getShort(at + 2) & 0xFFFF : buffer.getLong(at + 2);
        buffer.position(at + head);
        return true;
    }
}
