package org.dronemap.core.virtual;

import java.util.Locale;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;

/** A circle in which a drone must stand to serve a virtual drone. */
public record RequiredArea(Geodetic center, double radiusMeters) {
    public RequiredArea {
        if (!(radiusMeters >= 1 && radiusMeters <= 100_000)) {
            throw new IllegalArgumentException("a radius must be 1 to 100000 m: " + radiusMeters);
        }
    }

    boolean contains(Geodetic point) {
        return Geodesy.distanceMeters(center, point) <= radiusMeters;
    }

    String words() {
        return String.format(Locale.ROOT, "within %.0f m of %s", radiusMeters, center.words());
    }
}
