package org.dronemap.mavlink;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Encodes MAVLink frames of one sender: system and component id, version, and rising sequence numbers. Not thread-safe.
 */
public final class FrameWriter {
    private final int systemId;
    private final int componentId;
    private final int version;
    private int sequence;

    /** {@code version} is 1 or 2. */
    public FrameWriter(int systemId, int componentId, int version) {
        if (version != 1 && version != 2) {
            throw new IllegalArgumentException("a MAVLink version is 1 or 2: " + version);
        }
        this.systemId = systemId;
        this.componentId = componentId;
        this.version = version;
    }

    /**
     * The whole frame.
     *
     * @throws IllegalArgumentException for a message number above 255 in version 1
     */
    public byte[] frame(Message message) {
        PayloadWriter payload = new PayloadWriter();
        message.write(payload);
        return version == 2 ? frame2(message, payload, 0) : frame1(message, payload);
    }

    /**
     * The whole frame with a signature.
     *
     * @throws IllegalStateException in version 1, which knows no signatures
     */
    public byte[] frame(Message message, FrameSigner signer) {
        if (version != 2) {
            throw new IllegalStateException("MAVLink 1 frames cannot be signed");
        }
        PayloadWriter payload = new PayloadWriter();
        message.write(payload);
        byte[] raw = frame2(message, payload, Frame.SIGNATURE_BYTES);
        signer.sign(raw);
        return raw;
    }

    /**
     * What somebody else sent as this sender's own: in version 2, with its numbers, unsigned or signed anew. Empty for a
     * version 1 frame of a message that is not known here, whose checksum nobody could make.
     */
    public Optional<byte[]> copy(Frame received, @Nullable FrameSigner signer) {
        if (!received.verified() && received.version() == 1) {
            return Optional.empty();
        }
        byte[] bytes = received.withoutSignature().bytes();
        int payloadStart = received.version() == 2 ? Frame.HEADER_2 : Frame.HEADER_1;
        int length = received.payloadLength();
        while (received.verified() && length > 1 && bytes[payloadStart + length - 1] == 0) {
            length--;
        }
        byte[] raw = new byte[Frame.HEADER_2 + length + 2 + (signer == null ? 0 : Frame.SIGNATURE_BYTES)];
        header(raw, length, received.messageId(), signer != null);
        System.arraycopy(bytes, payloadStart, raw, Frame.HEADER_2, length);
        if (received.verified()) {
            checksum(raw, Frame.HEADER_2 + length, received.messageId());
        } else {
            mend(raw, bytes, length);
        }
        if (signer != null) {
            signer.sign(raw);
        }
        return Optional.of(raw);
    }

    /** Gives {@code raw} the checksum of {@code before}, changed by what was changed in the header. */
    private static void mend(byte[] raw, byte[] before, int payload) {
        int end = Frame.HEADER_2 + payload;
        int sum = (before[end] & 0xFF) | (before[end + 1] & 0xFF) << 8;
        raw[3] = before[3];
        for (int i = 1; i < Frame.HEADER_2; i++) {
            // What comes after it in the sum: the rest of the frame and the seed.
            sum ^= Crc.changeOf((raw[i] ^ before[i]) & 0xFF, end - i);
        }
        raw[end] = (byte) sum;
        raw[end + 1] = (byte) (sum >>> 8);
    }

    private byte[] frame2(Message message, PayloadWriter payload, int signatureBytes) {
        int length = payload.length();
        while (length > 1 && payload.array()[length - 1] == 0) {
            length--;
        }
        byte[] raw = new byte[Frame.HEADER_2 + length + 2 + signatureBytes];
        header(raw, length, message.messageId(), signatureBytes > 0);
        return finish(raw, Frame.HEADER_2, message, payload, length);
    }

    private byte[] frame1(Message message, PayloadWriter payload) {
        MessageTable.Entry entry = MessageTable.find(message.messageId());
        if (message.messageId() > 255 || entry == null) {
            throw new IllegalArgumentException("message " + message.messageId() + " cannot be sent as MAVLink 1");
        }
        int length = entry.shortestPayload();
        byte[] raw = new byte[Frame.HEADER_1 + length + 2];
        raw[0] = (byte) Frame.MAGIC_1;
        raw[1] = (byte) length;
        raw[2] = (byte) sequence++;
        raw[3] = (byte) systemId;
        raw[4] = (byte) componentId;
        raw[5] = (byte) message.messageId();
        return finish(raw, Frame.HEADER_1, message, payload, length);
    }

    private static byte[] finish(byte[] raw, int header, Message message, PayloadWriter payload, int length) {
        System.arraycopy(payload.array(), 0, raw, header, length);
        checksum(raw, header + length, message.messageId());
        return raw;
    }

    private void header(byte[] raw, int length, int messageId, boolean signed) {
        raw[0] = (byte) Frame.MAGIC_2;
        raw[1] = (byte) length;
        raw[2] = (byte) (signed ? Frame.SIGNED_FLAG : 0);
        raw[4] = (byte) sequence++;
        raw[5] = (byte) systemId;
        raw[6] = (byte) componentId;
        raw[7] = (byte) messageId;
        raw[8] = (byte) (messageId >>> 8);
        raw[9] = (byte) (messageId >>> 16);
    }

    private static void checksum(byte[] raw, int at, int messageId) {
        int crc = Crc.add(Crc.START, raw, 1, at - 1);
        crc = Crc.add(crc, MessageTable.checksumSeed(messageId));
        raw[at] = (byte) crc;
        raw[at + 1] = (byte) (crc >>> 8);
    }
}
