package org.dronemap.core.history;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * The state of the numbered series of events in a store.
 *
 * @param id of the series; a store that was made anew or restored from a backup has another one
 * @param newest the highest number that was given; 0: none was
 * @param expired the highest number of what was dropped because its time was over; 0: nothing was
 * @param expiredBefore what was dropped happened before that; null: nothing was
 */
public record EventSeries(
        String id, long newest, long expired, @Nullable Instant expiredBefore) {}
