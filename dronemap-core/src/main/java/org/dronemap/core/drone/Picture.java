package org.dronemap.core.drone;

import java.util.Arrays;
import java.util.Optional;

/** A JPEG or PNG image from a vehicle's camera or of its map; the bytes are never decoded here. Immutable. */
public final class Picture {
    /** Larger ones are not kept. */
    public static final int MOST_BYTES = 400_000;

    private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd8, (byte) 0xff};
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    private final byte[] bytes;
    private final boolean png;

    private Picture(byte[] bytes, boolean png) {
        this.bytes = bytes;
        this.png = png;
    }

    /** Empty for what is neither, and for what is too large. */
    public static Optional<Picture> of(byte[] bytes) {
        boolean png = begins(bytes, PNG);
        boolean known = png || begins(bytes, JPEG);
        return known && bytes.length <= MOST_BYTES ? Optional.of(new Picture(bytes.clone(), png)) : Optional.empty();
    }

    private static boolean begins(byte[] bytes, byte[] with) {
        return bytes.length > with.length && Arrays.equals(bytes, 0, with.length, with, 0, with.length);
    }

    /** Its media type. */
    public String mediaType() {
        return png ? "image/png" : "image/jpeg";
    }

    /** A copy. */
    public byte[] bytes() {
        return bytes.clone();
    }

    @Override
    public String toString() {
        return "Picture[" + mediaType() + ", " + bytes.length + " bytes]";
    }
}
