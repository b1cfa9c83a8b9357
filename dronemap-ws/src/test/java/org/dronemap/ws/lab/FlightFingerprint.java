package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.function.LongSupplier;

/** All frames of all wires, with their times, as one number that two equal flights have in common. */
final class FlightFingerprint {
    private final LongSupplier nanos;
    private final MessageDigest digest;
    private long frames;

    FlightFingerprint(LongSupplier nanos) {
        this.nanos = nanos;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    void said(String vehicle, byte[] bytes) {
        add('>', vehicle, bytes);
    }

    void told(String vehicle, byte[] bytes) {
        add('<', vehicle, bytes);
    }

    private void add(char way, String vehicle, byte[] bytes) {
        frames++;
        digest.update((byte) way);
        digest.update(vehicle.getBytes(StandardCharsets.UTF_8));
        digest.update(ByteBuffer.allocate(Long.BYTES).putLong(nanos.getAsLong()).array());
        digest.update(bytes);
    }

    /** Something else that equal flights have in common. */
    void note(String text) {
        digest.update(text.getBytes(StandardCharsets.UTF_8));
    }

    long frames() {
        return frames;
    }

    /** SHA-256 of all so far; nothing can be added any more. */
    String sum() {
        return HexFormat.of().formatHex(digest.digest());
    }
}
