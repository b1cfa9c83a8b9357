package org.dronemap.store.parquet;

import java.io.ByteArrayOutputStream;
import java.util.BitSet;

/** Packs bits for a Parquet file: truth values, and which values of a column are known. One thread. */
final class BitRun {
    private final BitSet bits = new BitSet();
    private int size;

    void add(boolean bit) {
        bits.set(size++, bit);
    }

    void writeBits(ByteArrayOutputStream out) {
        byte[] bytes = new byte[(size + 7) / 8];
        byte[] set = bits.toByteArray();
        System.arraycopy(set, 0, bytes, 0, set.length);
        out.writeBytes(bytes);
    }

    /** As one run of the hybrid that says which values are there: its length in bytes, its number of groups of eight, the bits. */
    void writeLevels(ByteArrayOutputStream out) {
        ByteArrayOutputStream run = new ByteArrayOutputStream();
        int header = (((size + 7) / 8) << 1) | 1;
        for (; header > 0x7F; header >>>= 7) {
            run.write((header & 0x7F) | 0x80);
        }
        run.write(header);
        writeBits(run);
        PlainEncoding.integer(run.size(), out);
        out.writeBytes(run.toByteArray());
    }
}
