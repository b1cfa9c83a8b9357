package org.dronemap.store.postgres;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/** Creates the SHA-256 digests that backups are checked by. */
final class Sha256 {
    private Sha256() {}

    static MessageDigest digest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
