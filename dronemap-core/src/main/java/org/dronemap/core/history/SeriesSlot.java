package org.dronemap.core.history;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Extents of the fields of a series within one slot; empty slots are left out.
 *
 * @param at of the first point in it
 * @param extents one for each field that was asked for, null where it was never known
 */
public record SeriesSlot(Instant at, List<@Nullable Extent> extents) {
    public SeriesSlot {
        extents = Collections.unmodifiableList(new ArrayList<>(extents));
    }

    /** The least and the greatest value, so that no peak is lost however coarse the slots are. */
    public record Extent(double least, double most) {
        Extent with(double value) {
            return new Extent(Math.min(least, value), Math.max(most, value));
        }
    }
}
