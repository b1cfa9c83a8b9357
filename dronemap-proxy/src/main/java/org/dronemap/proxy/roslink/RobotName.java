package org.dronemap.proxy.roslink;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.dronemap.core.cloud.Proof;
import org.jspecify.annotations.Nullable;

/**
 * By what the links of one robot are known to be its: the key that was issued to it, else a key of its own making together
 * with its system id, else its address.
 *
 * @param proof null where it shows no issued key
 * @param hardware what tells it from others where it proves nothing; null where it has an issued key, or none at all
 */
record RobotName(
        String text, @Nullable Proof proof, @Nullable String hardware) {
    private static final int SHOWN_DIGITS = 16;

    static RobotName ofIssued(RobotKeys.Issued issued) {
        return new RobotName("issued " + issued.identity(), new Proof.OfLink(issued.identity()), null);
    }

    /** A key that nobody issued is no secret and proves nothing, but robots keep theirs. */
    static RobotName ofOwnKey(String key, int systemId) {
        String digest = digest("robot " + systemId + " " + key).substring(0, SHOWN_DIGITS);
        return new RobotName("own " + digest, null, digest);
    }

    static RobotName ofAddress(String address) {
        return new RobotName("at " + address, null, null);
    }

    private static String digest(String text) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
