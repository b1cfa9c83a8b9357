package org.dronemap.core.drone;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * One sweep of a robot's range finder: distances in metres along rays, counter-clockwise from its nose. Immutable.
 *
 * @param firstAngleRadians of the first ray
 * @param stepRadians from each ray to the next
 * @param rangesMeters null where nothing was met, or nothing measured
 */
public record RangeScan(double firstAngleRadians, double stepRadians, List<@Nullable Double> rangesMeters) {
    /** More than any range finder in use measures in one sweep. */
    public static final int MOST_RAYS = 8_192;

    public RangeScan {
        if (rangesMeters.isEmpty() || rangesMeters.size() > MOST_RAYS) {
            throw new IllegalArgumentException("a sweep has 1 to " + MOST_RAYS + " rays: " + rangesMeters.size());
        }
        if (!Double.isFinite(firstAngleRadians) || !Double.isFinite(stepRadians)) {
            throw new IllegalArgumentException("a sweep has angles: " + firstAngleRadians + ", " + stepRadians);
        }
        rangesMeters = Collections.unmodifiableList(new ArrayList<>(rangesMeters));
    }
}
