package org.dronemap.core.access;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * The 32-byte secret that two MAVLink peers, such as a vehicle and the cloud, share to sign their messages. It never
 * shows itself: what may be told is its fingerprint. Immutable.
 */
public final class LinkKey {
    public static final int BYTES = 32;
    private static final int FINGERPRINT_LETTERS = 12;

    private final byte[] secret;

    /**
     * Keeps a copy.
     *
     * @throws IllegalArgumentException for another length, or for nothing but zeros, which means "no key" to vehicles
     */
    public LinkKey(byte[] secret) {
        if (secret.length != BYTES) {
            throw new IllegalArgumentException("a link key has " + BYTES + " bytes, not " + secret.length);
        }
        int any = 0;
        for (byte octet : secret) {
            any |= octet;
        }
        if (any == 0) {
            throw new IllegalArgumentException("a link key of zeros is no key");
        }
        this.secret = secret.clone();
    }

    /** The secret itself, a copy: for the vehicle, the encrypted store, and once for whoever made it. */
    public byte[] secret() {
        return secret.clone();
    }

    /** Tells keys apart without telling anything of them: twelve hexadecimal letters. */
    public String fingerprint() {
        try {
            MessageDigest sha256 = MessageDigest.getInstance("SHA-256");
            sha256.update("link key fingerprint".getBytes(StandardCharsets.US_ASCII));
            return HexFormat.of().formatHex(sha256.digest(secret)).substring(0, FINGERPRINT_LETTERS);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof LinkKey key && MessageDigest.isEqual(secret, key.secret);
    }

    @Override
    public int hashCode() {
        return fingerprint().hashCode();
    }

    @Override
    public String toString() {
        return "LinkKey[" + fingerprint() + "]";
    }
}
