package org.dronemap.core.lease;

import java.time.Duration;

/**
 * Timeouts of control, and the action when its holder is lost.
 *
 * @param silence without a heartbeat after which an explicit holder is lost; heartbeats come every 2 s
 * @param idle after the last command, until control that came with it ends
 * @param asking how long a request for control stands
 * @param onLoss what a drone that somebody has to attend to is told then
 * @param untilReturn from the hold to the return, when that is what happens
 */
public record LeaseRules(Duration silence, Duration idle, Duration asking, OnLoss onLoss, Duration untilReturn) {
    /** Action for a drone in manual or guided flight when the holder of its control is lost. */
    public enum OnLoss {
        NOTHING,
        HOLD,
        /** Hold, then return. */
        RETURN
    }

    public static final LeaseRules DEFAULT = new LeaseRules(
            Duration.ofSeconds(6),
            Duration.ofSeconds(30),
            Duration.ofSeconds(60),
            OnLoss.RETURN,
            Duration.ofSeconds(30));

    public LeaseRules {
        if (silence.compareTo(Duration.ofSeconds(3)) < 0) {
            throw new IllegalArgumentException(
                    "a holder who gives a sign every 2 s cannot be lost after " + silence.toSeconds() + " s");
        }
    }
}
