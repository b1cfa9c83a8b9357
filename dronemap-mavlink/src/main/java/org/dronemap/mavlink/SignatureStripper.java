package org.dronemap.mavlink;

/**
 * Removes the signature from a MAVLink frame before it is recorded, as the MAVLink guide advises. The checksum covers
 * the flag, so it is put right as well, by the difference that one flipped bit makes: that needs no checksum seed and
 * works for messages that nobody here knows. All other bytes stay as they were.
 */
public final class SignatureStripper {
    private static final int FLAGS = 2;
    private static final int FLAGS_TO_PAYLOAD = Frame.HEADER_2 - FLAGS - 1;
    private static final char[] DIFFERENCES = differences();

    private SignatureStripper() {}

    /** True for a whole frame that begins here and carries a signature. */
    public static boolean isOn(byte[] bytes, int at) {
        return (bytes[at] & 0xFF) == Frame.MAGIC_2 && (bytes[at + FLAGS] & Frame.SIGNED_FLAG) != 0;
    }

    /** Changes the frame that begins here, in place; its length from now on. */
    public static int strip(byte[] bytes, int at, int length) {
        if (!isOn(bytes, at)) {
            return length;
        }
        int payload = bytes[at + 1] & 0xFF;
        int difference = DIFFERENCES[payload];
        int checksum = at + Frame.HEADER_2 + payload;
        bytes[at + FLAGS] &= (byte) ~Frame.SIGNED_FLAG;
        bytes[checksum] ^= (byte) difference;
        bytes[checksum + 1] ^= (byte) (difference >>> 8);
        return length - Frame.SIGNATURE_BYTES;
    }

    /** By payload length: what the flag's bit adds to the checksum, seed byte and all. */
    private static char[] differences() {
        char[] differences = new char[256];
        for (int payload = 0; payload < differences.length; payload++) {
            differences[payload] = (char) Crc.changeOf(Frame.SIGNED_FLAG, FLAGS_TO_PAYLOAD + payload + 1);
        }
        return differences;
    }
}
