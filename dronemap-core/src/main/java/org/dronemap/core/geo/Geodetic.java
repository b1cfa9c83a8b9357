package org.dronemap.core.geo;

import java.util.Locale;
import org.dronemap.core.stored.Stored;

/** A point on WGS-84, degrees; altitudes are carried beside it with their reference. */
@Stored(names = "latitudeDegrees longitudeDegrees")
public record Geodetic(double latitudeDegrees, double longitudeDegrees) {
    public Geodetic {
        if (!(Math.abs(latitudeDegrees) <= 90)) {
            throw new IllegalArgumentException("latitude must be -90 to 90 degrees: " + latitudeDegrees);
        }
        if (!(Math.abs(longitudeDegrees) <= 180)) {
            throw new IllegalArgumentException("longitude must be -180 to 180 degrees: " + longitudeDegrees);
        }
    }

    /** For people: "47.397700, 8.545600". */
    public String words() {
        return String.format(Locale.ROOT, "%.6f, %.6f", latitudeDegrees, longitudeDegrees);
    }
}
