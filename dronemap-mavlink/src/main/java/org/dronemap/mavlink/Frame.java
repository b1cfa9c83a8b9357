package org.dronemap.mavlink;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A received MAVLink frame, version 1 or 2; immutable. Payload reads are little-endian and answer 0 beyond the
 * payload's end, since version 2 cuts trailing zeros (MAVLink guide, "Empty-byte payload truncation").
 */
public final class Frame {
    static final int MAGIC_1 = 0xFE;
    static final int MAGIC_2 = 0xFD;
    static final int HEADER_1 = 6;
    static final int HEADER_2 = 10;
    /** What a signature adds to a frame: link id, timestamp, digest. */
    public static final int SIGNATURE_BYTES = 13;

    static final int SIGNED_FLAG = 1;

    private final byte[] raw;
    private final int payloadStart;
    private final boolean verified;

    /** {@code raw} is owned by the frame from now on: magic to checksum or signature. */
    Frame(byte[] raw, boolean verified) {
        this.raw = raw;
        this.verified = verified;
        this.payloadStart = version() == 2 ? HEADER_2 : HEADER_1;
    }

    /** 1 or 2. */
    public int version() {
        return (raw[0] & 0xFF) == MAGIC_2 ? 2 : 1;
    }

    /** False when the checksum could not be checked because the message is not known here. */
    public boolean verified() {
        return verified;
    }

    public boolean signed() {
        return version() == 2 && (raw[2] & SIGNED_FLAG) != 0;
    }

    /** The sender's number of the link that it signed for; 0 without a signature. */
    public int signatureLinkId() {
        return signed() ? raw[raw.length - SIGNATURE_BYTES] & 0xFF : 0;
    }

    /** When it was signed, in 10 µs steps since 2015-01-01 UTC; 0 without a signature. */
    public long signatureTimestamp() {
        long timestamp = 0;
        for (int i = 6; signed() && i > 0; i--) {
            timestamp = timestamp << 8 | (raw[raw.length - SIGNATURE_BYTES + i] & 0xFF);
        }
        return timestamp;
    }

    /** The same frame as an unsigned one, for recordings and relays: only flag, checksum and signature differ. */
    public Frame withoutSignature() {
        if (!signed()) {
            return this;
        }
        byte[] bare = raw.clone();
        int length = SignatureStripper.strip(bare, 0, bare.length);
        return new Frame(Arrays.copyOf(bare, length), verified);
    }

    public int payloadLength() {
        return raw[1] & 0xFF;
    }

    public int sequence() {
        return raw[payloadStart == HEADER_2 ? 4 : 2] & 0xFF;
    }

    public int systemId() {
        return raw[payloadStart == HEADER_2 ? 5 : 3] & 0xFF;
    }

    public int componentId() {
        return raw[payloadStart == HEADER_2 ? 6 : 4] & 0xFF;
    }

    public int messageId() {
        return payloadStart == HEADER_2
                ? (raw[7] & 0xFF) | (raw[8] & 0xFF) << 8 | (raw[9] & 0xFF) << 16
                : raw[5] & 0xFF;
    }

    /** The whole frame as received, a copy. */
    public byte[] bytes() {
        return raw.clone();
    }

    /** The whole frame as received, length in bytes. */
    public int length() {
        return raw.length;
    }

    /** Appends the frame as received. */
    public void writeTo(ByteBuffer out) {
        out.put(raw);
    }

    public int u8(int offset) {
        return offset < payloadLength() ? raw[payloadStart + offset] & 0xFF : 0;
    }

    public int i8(int offset) {
        return (byte) u8(offset);
    }

    public int u16(int offset) {
        return u8(offset) | u8(offset + 1) << 8;
    }

    public int i16(int offset) {
        return (short) u16(offset);
    }

    public int i32(int offset) {
        return u16(offset) | u16(offset + 2) << 16;
    }

    public long u32(int offset) {
        return i32(offset) & 0xFFFF_FFFFL;
    }

    public long i64(int offset) {
        return u32(offset) | u32(offset + 4) << 32;
    }

    public float f32(int offset) {
        return Float.intBitsToFloat(i32(offset));
    }

    public int[] u8s(int offset, int count) {
        int[] values = new int[count];
        for (int i = 0; i < count; i++) {
            values[i] = u8(offset + i);
        }
        return values;
    }

    public int[] u16s(int offset, int count) {
        int[] values = new int[count];
        for (int i = 0; i < count; i++) {
            values[i] = u16(offset + 2 * i);
        }
        return values;
    }

    public float[] f32s(int offset, int count) {
        float[] values = new float[count];
        for (int i = 0; i < count; i++) {
            values[i] = f32(offset + 4 * i);
        }
        return values;
    }

    /** ASCII up to the first zero byte, at most {@code length} bytes; what is no ASCII becomes '?'. */
    public String text(int offset, int length) {
        int end = offset;
        while (end < offset + length && u8(end) != 0) {
            end++;
        }
        if (end == offset) {
            return "";
        }
        String text = new String(raw, payloadStart + offset, end - offset, StandardCharsets.UTF_8);
        return text.replaceAll("[\\p{Cntrl}\\uFFFD]", "?");
    }

    @Override
    public String toString() {
        return "Frame[v" + version() + " message " + messageId() + " from " + systemId() + "/" + componentId() + " #"
                + sequence() + "]";
    }
}
