package org.dronemap.proxy.session;

/** Limits the identification requests that the server sends to unknown vehicles, over all of them. Thread-safe. */
public final class IdentificationRateLimiter {
    private static final double A_SECOND = 200;
    private static final double AT_ONCE = 400;

    private double left = AT_ONCE;
    private long lastNanos;
    private boolean begun;

    synchronized boolean tryAcquire(long nowNanos) {
        if (begun) {
            left = Math.min(AT_ONCE, left + (nowNanos - lastNanos) / 1e9 * A_SECOND);
        }
        begun = true;
        lastNanos = nowNanos;
        if (left < 1) {
            return false;
        }
        left--;
        return true;
    }
}
