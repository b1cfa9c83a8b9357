package org.dronemap.mavlink;

/** The checksum of MAVLink frames: CRC-16/MCRF4XX (X.25 without final inversion), by table. */
final class Crc {
    static final int START = 0xFFFF;
    private static final char[] TABLE = table();

    private Crc() {}

    static int add(int crc, byte[] bytes, int from, int length) {
        int sum = crc;
        for (int i = from; i < from + length; i++) {
            sum = add(sum, bytes[i]);
        }
        return sum;
    }

    static int add(int crc, int octet) {
        return (crc >>> 8) ^ TABLE[(crc ^ octet) & 0xFF];
    }

    /**
     * What flipping these bits of one byte does to the checksum, {@code behind} bytes after it: the sum is linear, so it
     * can be mended without knowing the message.
     */
    static int changeOf(int flipped, int behind) {
        int sum = add(0, flipped);
        for (int i = 0; i < behind; i++) {
            sum = add(sum, 0);
        }
        return sum;
    }

    private static char[] table() {
        char[] table = new char[256];
        for (int i = 0; i < 256; i++) {
            int value = i;
            for (int bit = 0; bit < 8; bit++) {
                value = (value & 1) == 0 ? value >>> 1 : (value >>> 1) ^ 0x8408;
            }
            table[i] = (char) value;
        }
        return table;
    }
}
