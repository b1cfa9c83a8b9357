package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.jspecify.annotations.Nullable;

/** Takes a target to be where it was reported last, and to stand there. */
final class LastReport implements Followed {
    private final LocalPlane plane;
    private @Nullable Spot last;

    LastReport(Geodetic near) {
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
    public @Nullable Motion at(Instant time) {
        Spot known = last;
        return known == null ? null : new Motion(known.eastMeters(), known.northMeters(), 0, 0, 0);
    }
}
