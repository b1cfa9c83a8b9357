package org.dronemap.ws.security;

import java.time.Duration;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.problem.RateLimitRejection;
import org.dronemap.ws.problem.ServerProblem;
import org.springframework.security.crypto.argon2.Argon2PasswordEncoder;

/** Hashes users' passwords with Argon2id (16 MiB, two passes), two at a time and few waiting, to bound memory. */
public final class Argon2Passwords implements PasswordHashing {
    private static final int SALT_BYTES = 16;
    private static final int HASH_BYTES = 32;
    private static final int USUAL_MEMORY_KIB = 16 * 1024;
    private static final int USUAL_PASSES = 2;
    private static final int MOST_WAITING = 32;
    private static final Duration WAIT = Duration.ofSeconds(2);

    private final Argon2PasswordEncoder encoder;
    private final Semaphore atOnce = new Semaphore(2);
    private final Semaphore waiting = new Semaphore(MOST_WAITING);

    public Argon2Passwords() {
        this(USUAL_MEMORY_KIB, USUAL_PASSES);
    }

    /** As dear as that to guess: memory in KiB. For tests, which are not to spend their time on it. */
    public Argon2Passwords(int memoryKib, int passes) {
        encoder = new Argon2PasswordEncoder(SALT_BYTES, HASH_BYTES, 1, memoryKib, passes);
    }

    @Override
    public String hash(String password) {
        return inTurn(() -> String.valueOf(encoder.encode(password)));
    }

    @Override
    public boolean matches(String password, String hash) {
        return inTurn(() -> encoder.matches(password, hash));
    }

    private <T> T inTurn(Supplier<T> work) {
        if (!waiting.tryAcquire()) {
            throw RateLimitRejection.of(
                    ServerProblem.SIGN_INS_CROWDED, "Too many people are signing in at this moment", WAIT);
        }
        try {
            atOnce.acquireUninterruptibly();
            try {
                return work.get();
            } finally {
                atOnce.release();
            }
        } finally {
            waiting.release();
        }
    }
}
