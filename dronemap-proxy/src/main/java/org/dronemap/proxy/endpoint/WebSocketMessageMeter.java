package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;

/** Measures from frame headers (RFC 6455, section 5.2) how long an incoming WebSocket message is, to limit it. */
final class WebSocketMessageMeter {
    /** Of one message. Clients send whole messages, or pieces of some kB. */
    static final int MOST_PIECES = 1_024;

    private static final int LONGEST_HEADER = 14;
    private static final int LENGTH_IN_TWO_BYTES = 126;
    private static final int LENGTH_IN_EIGHT_BYTES = 127;

    private final byte[] header = new byte[LONGEST_HEADER];
    private int headerBytes;
    private long payloadLeft;
    private long messageBytes;
    private int pieces;

    /** Reads on; false as soon as a message is announced to have more than {@code most} bytes, or comes in too many pieces. */
    boolean fits(ByteBuffer bytes, int most) {
        while (bytes.hasRemaining()) {
            if (payloadLeft > 0) {
                int skipped = (int) Math.min(payloadLeft, bytes.remaining());
                bytes.position(bytes.position() + skipped);
                payloadLeft -= skipped;
            } else {
                header[headerBytes++] = bytes.get();
                if (headerBytes >= 2 && headerBytes == headerLength() && !begins(most)) {
                    return false;
                }
            }
        }
        return true;
    }

    private int headerLength() {
        int masked = header[1] < 0 ? 4 : 0;
        return switch (header[1] & 0x7f) {
            case LENGTH_IN_TWO_BYTES -> 4 + masked;
            case LENGTH_IN_EIGHT_BYTES -> 10 + masked;
            default -> 2 + masked;
        };
    }

    private boolean begins(int most) {
        headerBytes = 0;
        long length = payloadLength();
        if (length < 0 || length > most) {
            return false;
        }
        payloadLeft = length;
        int opcode = header[0] & 0x0f;
        boolean control = (opcode & 0x08) != 0;
        if (control) {
            return true;
        }
        if (opcode != 0) {
            messageBytes = 0;
            pieces = 0;
        }
        messageBytes += length;
        pieces++;
        return messageBytes <= most && pieces <= MOST_PIECES;
    }

    private long payloadLength() {
        ByteBuffer told = ByteBuffer.wrap(header);
        int small = header[1] & 0x7f;
        return switch (small) {
            case LENGTH_IN_TWO_BYTES -> told.getShort(2) & 0xffff;
            case LENGTH_IN_EIGHT_BYTES -> told.getLong(2);
            default -> small;
        };
    }
}
