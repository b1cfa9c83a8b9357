package org.dronemap.proxy.endpoint;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** Speaks WebSocket frame by frame, as it is told, over a socket of its own; masks with zeros. */
final class WebSocketPeer implements AutoCloseable {
    static final int CONTINUED = 0x00;
    static final int TEXT = 0x01;
    static final int BINARY = 0x02;
    static final int CLOSE = 0x08;
    static final int PING = 0x09;
    static final int LAST = 0x80;

    private final Socket socket = new Socket();
    private final DataInputStream in;
    private final OutputStream out;

    WebSocketPeer(int port) throws IOException {
        socket.setReceiveBufferSize(2_048);
        socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
        socket.setSoTimeout(10_000);
        in = new DataInputStream(socket.getInputStream());
        out = socket.getOutputStream();
        out.write(("GET /a HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                        + "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n")
                .getBytes(StandardCharsets.US_ASCII));
        for (String head = ""; !head.endsWith("\r\n\r\n"); ) {
            head += (char) in.readUnsignedByte();
        }
    }

    void says(int first, byte[] payload) throws IOException {
        says(first, payload.length, payload);
    }

    /** A frame that announces another length than it has so far. */
    void says(int first, int announced, byte[] payload) throws IOException {
        ByteBuffer frame = ByteBuffer.allocate(14 + payload.length);
        frame.put((byte) first)
                .put((byte) (0x80 | 127))
                .putLong(announced)
                .putInt(0)
                .put(payload);
        out.write(frame.array());
    }

    /** A frame of at most 125 bytes. */
    void saysShort(int first, byte[] payload) throws IOException {
        ByteBuffer frame = ByteBuffer.allocate(6 + payload.length);
        frame.put((byte) first).put((byte) (0x80 | payload.length)).putInt(0).put(payload);
        out.write(frame.array());
    }

    /** The code of the farewell, past all else that is said before. */
    int farewell() throws IOException {
        while (true) {
            int opcode = in.readUnsignedByte() & 0x0f;
            int length = in.readUnsignedByte();
            if (length == 126) {
                length = in.readUnsignedShort();
            }
            byte[] payload = in.readNBytes(length);
            if (opcode == CLOSE) {
                return ByteBuffer.wrap(payload).getShort();
            }
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
