package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.jspecify.annotations.Nullable;

/** Takes a target to be where it was reported last, and to stand there. */
final class LastReportTarget implements TrackedTarget {
    private final LocalPlane plane;
    private @Nullable PlanePoint last;

    LastReportTarget(Geodetic near) {
        plane = new LocalPlane(near);
    }

    void take(PhoneFix fix) {
        last = plane.spot(fix.point());
    }

    @Override
    public LocalPlane plane() {
        return plane;
    }

    @Override
    public @Nullable PlanarMotion at(Instant time) {
        PlanePoint known = last;
        return known == null ? null : new PlanarMotion(known.eastMeters(), known.northMeters(), 0, 0, 0);
    }
}
