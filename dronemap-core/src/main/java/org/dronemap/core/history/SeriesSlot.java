package org.dronemap.core.history;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * One slot of a time series of telemetry: least and greatest value of each field.
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
