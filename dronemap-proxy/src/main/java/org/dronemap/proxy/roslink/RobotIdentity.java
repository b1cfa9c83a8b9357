package org.dronemap.proxy.roslink;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.dronemap.core.cloud.IdentityProof;
import org.dronemap.core.link.RobotKey;
import org.jspecify.annotations.Nullable;

/**
 * The identity that joins a robot's links: the key issued to it, its own key and system id, or its address.
 *
 * @param issued its key; null where it shows none
 * @param hardware what tells it from others where it proves nothing; null where it has an issued key, or none at all
 */
record RobotIdentity(
        String text, @Nullable RobotKey issued, @Nullable String hardware) {
    private static final int SHOWN_DIGITS = 16;

    static RobotIdentity ofIssued(RobotKey issued) {
        return new RobotIdentity("issued " + issued.drone(), issued, null);
    }

    /** Null where it shows no issued key. */
    @Nullable
    IdentityProof proof() {
        return issued == null ? null : new IdentityProof.OfLink(issued.drone().value(), issued.drone());
    }

    /** A key that nobody issued is no secret and proves nothing, but robots keep theirs. */
    static RobotIdentity ofOwnKey(String key, int systemId) {
        String digest = digest("robot " + systemId + " " + key).substring(0, SHOWN_DIGITS);
        return new RobotIdentity("own " + digest, null, digest);
    }

    static RobotIdentity ofAddress(String address) {
        return new RobotIdentity("at " + address, null, null);
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
