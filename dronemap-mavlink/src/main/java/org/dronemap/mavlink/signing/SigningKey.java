package org.dronemap.mavlink.signing;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import org.dronemap.mavlink.Frame;

/**
 * A MAVLink signing key: 32 secret bytes that a vehicle and its ground station share. It never shows itself: its text
 * is always the same. Immutable.
 */
public final class SigningKey {
    public static final int BYTES = 32;
    static final int DIGEST_BYTES = 6;

    private final byte[] secret;

    /**
     * Keeps a copy.
     *
     * @throws IllegalArgumentException for any other length than 32 bytes
     */
    public SigningKey(byte[] secret) {
        if (secret.length != BYTES) {
            throw new IllegalArgumentException("a signing key has " + BYTES + " bytes, not " + secret.length);
        }
        this.secret = secret.clone();
    }

    /** The secret itself, a copy: for the vehicle and the encrypted store only. */
    public byte[] secret() {
        return secret.clone();
    }

    /** The first 48 bits of SHA-256 over key and frame, up to but without the digest at the frame's end. */
    byte[] digest(byte[] frame) {
        MessageDigest sha256 = sha256();
        sha256.update(secret);
        sha256.update(frame, 0, frame.length - DIGEST_BYTES);
        return Arrays.copyOf(sha256.digest(), DIGEST_BYTES);
    }

    /** True when this key made the frame's signature; says nothing of its time. */
    public boolean signed(Frame frame) {
        if (!frame.signed()) {
            return false;
        }
        byte[] raw = frame.bytes();
        byte[] claimed = Arrays.copyOfRange(raw, raw.length - DIGEST_BYTES, raw.length);
        return MessageDigest.isEqual(claimed, digest(raw));
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java runtime has SHA-256", e);
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SigningKey key && MessageDigest.isEqual(secret, key.secret);
    }

    /** The same for all keys: a hash would tell something of the secret. */
    @Override
    public int hashCode() {
        return BYTES;
    }

    @Override
    public String toString() {
        return "SigningKey[secret]";
    }
}
