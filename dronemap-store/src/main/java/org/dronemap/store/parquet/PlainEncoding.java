package org.dronemap.store.parquet;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Encodes the values of one column in Parquet's plain encoding, the lowest byte first. One thread. */
final class PlainEncoding {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final BitRun truths = new BitRun();

    void add(Object value) {
        if (value instanceof String text) {
            byte[] encoded = text.getBytes(StandardCharsets.UTF_8);
            integer(encoded.length, bytes);
            bytes.writeBytes(encoded);
        } else if (value instanceof Long number) {
            number(number, Long.BYTES, bytes);
        } else if (value instanceof Double number) {
            number(Double.doubleToRawLongBits(number), Long.BYTES, bytes);
        } else if (value instanceof Float number) {
            integer(Float.floatToRawIntBits(number), bytes);
        } else if (value instanceof Integer number) {
            integer(number, bytes);
        } else if (value instanceof Boolean truth) {
            truths.add(truth);
        } else {
            throw new IllegalArgumentException("no column is of the kind of " + value.getClass());
        }
    }

    void writeTo(ByteArrayOutputStream out) {
        out.writeBytes(bytes.toByteArray());
        truths.writeBits(out);
    }

    static void integer(int value, ByteArrayOutputStream out) {
        number(value, Integer.BYTES, out);
    }

    private static void number(long value, int size, ByteArrayOutputStream out) {
        for (int i = 0; i < size; i++) {
            out.write((int) (value >>> (8 * i)));
        }
    }
}
