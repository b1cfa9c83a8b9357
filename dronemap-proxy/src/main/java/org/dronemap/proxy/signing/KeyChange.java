package org.dronemap.proxy.signing;

import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Sets or removes the MAVLink signing key on a vehicle, with retries, and recognises which key it then uses. No I/O;
 * times are monotonic ns. Guarded by its keyring.
 */
final class KeyChange {
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final int TRIES = 5;
    private static final long BETWEEN_TRIES_NANOS = 2 * SECOND_NANOS;
    private static final long HOLD_NANOS = 1_500_000_000L;
    private static final long PATIENCE_NANOS = 3 * SECOND_NANOS;
    /** What the vehicle sent before it read our request has arrived by then. */
    private static final long IN_FLIGHT_NANOS = SECOND_NANOS;

    private static final Pattern REFUSAL = Pattern.compile(
            "(?i)(error|fail|won't|denied|refuse|not allowed).*sign|sign.*(fail|denied|refuse|not allowed)");

    private final KeyChangeKind kind;
    private int tries;
    private long lastTryNanos;
    private boolean oldKeyUsedSince;
    private @Nullable KeyChangeResult result;

    /** The key that a valid frame was signed with. */
    enum Use {
        OLD,
        NEW,
        NONE
    }

    KeyChange(KeyChangeKind kind) {
        this.kind = kind;
    }

    KeyChangeKind kind() {
        return kind;
    }

    /** True when the vehicle is to be asked (again) now; the caller sends, once. */
    boolean due(long nowNanos) {
        if (result != null || (tries > 0 && nowNanos - lastTryNanos < BETWEEN_TRIES_NANOS) || tries == TRIES) {
            conclude(nowNanos);
            return false;
        }
        tries++;
        lastTryNanos = nowNanos;
        oldKeyUsedSince = false;
        return true;
    }

    private void conclude(long nowNanos) {
        if (result != null || tries < TRIES || nowNanos - lastTryNanos < PATIENCE_NANOS) {
            return;
        }
        result = oldKeyUsedSince
                ? new KeyChangeResult.Failed(
                        KeyChangeFault.NOT_DONE, "The vehicle was asked " + TRIES + " times and goes on as before.")
                : new KeyChangeResult.Unknown("The vehicle was asked " + TRIES + " times and was not heard since.");
    }

    /** A frame of the vehicle that is beyond doubt, and how it was signed. */
    void received(Use use, long nowNanos) {
        if (result != null || tries == 0) {
            return;
        }
        if (use == (kind == KeyChangeKind.REVOKE ? Use.NONE : Use.NEW)) {
            result = new KeyChangeResult.Done();
        } else if (nowNanos - lastTryNanos > IN_FLIGHT_NANOS) {
            oldKeyUsedSince = true;
        }
    }

    /** The vehicle says something; a complaint about signing is its answer. */
    void textReceived(String text) {
        if (result == null && tries > 0 && REFUSAL.matcher(text).find()) {
            result = new KeyChangeResult.Failed(KeyChangeFault.REFUSED, "The vehicle says: " + text);
        }
    }

    /** True while what goes out could be signed with the wrong key. */
    boolean holds(long nowNanos) {
        return result == null && kind != KeyChangeKind.INSTALL && tries > 0 && nowNanos - lastTryNanos < HOLD_NANOS;
    }

    @Nullable
    KeyChangeResult result() {
        return result;
    }
}
