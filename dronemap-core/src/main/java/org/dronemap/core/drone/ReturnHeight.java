package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** Return height over home that the cloud has set, and the one set before it, in metres. */
@Stored(names = "meters beforeMeters")
public record ReturnHeight(double meters, double beforeMeters) {
    private static final double SAME_METERS = 0.5;

    /**
     * The same as it counts after another one of the cloud's: set over a height that was not put back, what was set before
     * that is what has to be put back.
     *
     * @param last the one before; null: there was none
     */
    public ReturnHeight after(@Nullable ReturnHeight last) {
        boolean over = last != null && !last.isPutBack() && areSame(beforeMeters, last.meters);
        if (last == null || !over) {
            return this;
        }
        return new ReturnHeight(meters, areSame(meters, last.beforeMeters) ? meters : last.beforeMeters);
    }

    private boolean isPutBack() {
        return areSame(meters, beforeMeters);
    }

    private static boolean areSame(double one, double other) {
        return Math.abs(one - other) < SAME_METERS;
    }
}
