package org.dronemap.ws.security;

import java.util.concurrent.Semaphore;
import org.dronemap.ws.service.PasswordHashing;
import org.springframework.security.crypto.argon2.Argon2PasswordEncoder;

/** Argon2id with 16 MiB and two passes; at most two at a time, so that a flood of guesses cannot eat the memory. */
public final class Argon2Passwords implements PasswordHashing {
    private static final int SALT_BYTES = 16;
    private static final int HASH_BYTES = 32;
    private static final int MEMORY_KIB = 16 * 1024;
    private static final int PASSES = 2;

    private final Argon2PasswordEncoder encoder =
            new Argon2PasswordEncoder(SALT_BYTES, HASH_BYTES, 1, MEMORY_KIB, PASSES);
    private final Semaphore atOnce = new Semaphore(2);

    @Override
    public String hash(String password) {
        atOnce.acquireUninterruptibly();
        try {
            return String.valueOf(encoder.encode(password));
        } finally {
            atOnce.release();
        }
    }

    @Override
    public boolean matches(String password, String hash) {
        atOnce.acquireUninterruptibly();
        try {
            return encoder.matches(password, hash);
        } finally {
            atOnce.release();
        }
    }
}
