package org.dronemap.core.zone;

import java.util.Locale;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** Altitudes of a zone or of flight bounds: floor and ceiling in metres from one reference; null for no bound. */
@Stored(names = "floorMeters ceilingMeters reference")
public record AltitudeBand(
        @Nullable Double floorMeters, @Nullable Double ceilingMeters, Altitude.Reference reference) {
    public static final AltitudeBand ALL = new AltitudeBand(null, null, Altitude.Reference.HOME);

    public AltitudeBand {
        if (!planned(floorMeters) || !planned(ceilingMeters)) {
            throw new IllegalArgumentException("floor and ceiling must be -500 to 10000 m");
        }
        if (floorMeters != null && ceilingMeters != null && floorMeters >= ceilingMeters) {
            throw new IllegalArgumentException("the ceiling must be above the floor");
        }
    }

    private static boolean planned(@Nullable Double meters) {
        return meters == null
                || (meters >= Altitude.LOWEST_PLANNED_METERS && meters <= Altitude.HIGHEST_PLANNED_METERS);
    }

    public boolean isBounded() {
        return floorMeters != null || ceilingMeters != null;
    }

    public double lowMeters() {
        return floorMeters == null ? Double.NEGATIVE_INFINITY : floorMeters;
    }

    public double highMeters() {
        return ceilingMeters == null ? Double.POSITIVE_INFINITY : ceilingMeters;
    }

    /** Heights of different references cannot be compared as long as nobody flies. */
    public boolean isWithin(AltitudeBand outer) {
        return !outer.isBounded()
                || (reference == outer.reference
                        && lowMeters() >= outer.lowMeters()
                        && highMeters() <= outer.highMeters());
    }

    /** "10 to 120 m above home", "up to 500 m above sea level"; empty without bounds. */
    public String words() {
        if (floorMeters == null) {
            return ceilingMeters == null ? "" : "up to " + words(ceilingMeters);
        }
        return ceilingMeters == null
                ? "from " + words(floorMeters) + " upwards"
                : number(floorMeters) + " to " + words(ceilingMeters);
    }

    /** "120 m above home", "500 m above sea level". */
    String words(double meters) {
        return number(meters) + " m above " + (reference == Altitude.Reference.HOME ? "home" : "sea level");
    }

    private static String number(double meters) {
        return meters == Math.rint(meters) ? String.format(Locale.ROOT, "%.0f", meters) : String.valueOf(meters);
    }
}
