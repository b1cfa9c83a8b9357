package org.dronemap.cognitive.operation.run.model;

import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Share of a mission run in the drones of the pool: the cloud chose them, and replaces those that are lost.
 *
 * @param upTo so many fly at the same time, at most
 * @param whyNone why no other one could join when one was looked for last, as one or more sentences; null: one may
 */
@Stored(names = "upTo whyNone")
public record RunPool(int upTo, @Nullable String whyNone) {
    public static final int MOST_DRONES = 100;

    public RunPool {
        if (upTo < 1 || upTo > MOST_DRONES) {
            throw new IllegalArgumentException("a run has 1 to " + MOST_DRONES + " drones of the pool: " + upTo);
        }
    }
}
