package org.dronemap.core.history;

import java.time.Duration;

/**
 * Settings of the history: how often states are stored, and how long they are kept.
 *
 * @param flying a state is kept this often of each armed drone
 * @param resting the same of one that is not armed
 */
public record HistoryPolicy(Duration flying, Duration resting, Retention retention) {
    public static final HistoryPolicy DEFAULT =
            new HistoryPolicy(Duration.ofMillis(200), Duration.ofSeconds(5), Retention.DEFAULT);

    public HistoryPolicy {
        if (flying.isNegative() || flying.isZero() || resting.isNegative() || resting.isZero()) {
            throw new IllegalArgumentException("states are kept at times that are apart: " + flying + ", " + resting);
        }
    }
}
