package org.dronemap.mavlink;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Writes the fields of a MAVLink payload, little-endian and in wire order. Not thread-safe. */
public final class PayloadWriter {
    private static final int LONGEST = 255;

    private final ByteBuffer buffer = ByteBuffer.allocate(LONGEST).order(ByteOrder.LITTLE_ENDIAN);

    public void u8(int value) {
        buffer.put((byte) value);
    }

    public void i8(int value) {
        buffer.put((byte) value);
    }

    public void u16(int value) {
        buffer.putShort((short) value);
    }

    public void i16(int value) {
        buffer.putShort((short) value);
    }

    public void i32(int value) {
        buffer.putInt(value);
    }

    public void u32(long value) {
        buffer.putInt((int) value);
    }

    public void i64(long value) {
        buffer.putLong(value);
    }

    public void f32(float value) {
        buffer.putFloat(value);
    }

    public void u8s(int[] values, int count) {
        for (int i = 0; i < count; i++) {
            u8(i < values.length ? values[i] : 0);
        }
    }

    public void u16s(int[] values, int count) {
        for (int i = 0; i < count; i++) {
            u16(i < values.length ? values[i] : 0);
        }
    }

    public void f32s(float[] values, int count) {
        for (int i = 0; i < count; i++) {
            f32(i < values.length ? values[i] : 0);
        }
    }

    /** Cut at {@code count} bytes, filled with zeros. */
    public void text(String text, int count) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        int used = Math.min(count, bytes.length);
        buffer.put(bytes, 0, used);
        buffer.put(new byte[count - used]);
    }

    byte[] array() {
        return buffer.array();
    }

    int length() {
        return buffer.position();
    }
}
