package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.LocalPlane;
import org.jspecify.annotations.Nullable;

/** A target that a drone is guided beside: its motion on a local plane at a given time. */
public interface TrackedTarget {
    /** What its motion is counted in. */
    LocalPlane plane();

    /** Where it is at a time, at most some seconds after the newest fix, and how it moves; null: nothing is known of it. */
    @Nullable
    PlanarMotion at(Instant time);
}
