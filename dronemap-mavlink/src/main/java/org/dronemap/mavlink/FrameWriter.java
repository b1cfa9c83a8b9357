package org.dronemap.mavlink;

/**
 * Builds frames as one sender: system and component id, version, and a sequence number that rises with each frame. Not
 * thread-safe.
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

    private byte[] frame2(Message message, PayloadWriter payload, int signatureBytes) {
        int length = payload.length();
        while (length > 1 && payload.array()[length - 1] == 0) {
            length--;
        }
        byte[] raw = new byte[Frame.HEADER_2 + length + 2 + signatureBytes];
        raw[0] = (byte) Frame.MAGIC_2;
        raw[1] = (byte) length;
        raw[2] = (byte) (signatureBytes > 0 ? Frame.SIGNED_FLAG : 0);
        raw[4] = (byte) sequence++;
        raw[5] = (byte) systemId;
        raw[6] = (byte) componentId;
        raw[7] = (byte) message.messageId();
        raw[8] = (byte) (message.messageId() >>> 8);
        raw[9] = (byte) (message.messageId() >>> 16);
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
        int crc = Crc.add(Crc.START, raw, 1, header - 1 + length);
        crc = Crc.add(crc, MessageTable.checksumSeed(message.messageId()));
        raw[header + length] = (byte) crc;
        raw[header + length + 1] = (byte) (crc >>> 8);
        return raw;
    }
}
