package org.dronemap.ws.zone;

import java.util.Locale;
import java.util.Set;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import tools.jackson.databind.JsonNode;

/**
 * The coordinate reference system that older GeoJSON files name. In another one than longitude and latitude in degrees
 * the numbers of a file mean other places, which may exist too.
 */
final class GeoJsonReferenceSystem {
    private static final String WANTED = "longitude and latitude in degrees (CRS84, EPSG:4326)";
    /** ETRS89 and NAD83 are within two metres of WGS 84. */
    private static final Set<String> DEGREES = Set.of("CRS84", "CRS84H", "CRS83", "4326", "4979", "4258", "4269");

    private GeoJsonReferenceSystem() {}

    /** Throws {@link InvalidInput} for a file in another one; nothing (null) is the usual one. */
    static void check(JsonNode crs) {
        // What names no system says nothing about one.
        if (crs.isNull() || (crs.isObject() && !crs.has("properties"))) {
            return;
        }
        JsonNode name = crs.path("properties").path("name");
        String written = name.isString() ? name.asString() : crs.toString();
        String last = written.substring(Math.max(written.lastIndexOf(':'), written.lastIndexOf('/')) + 1);
        if (!name.isString() || !DEGREES.contains(last.strip().toUpperCase(Locale.ROOT))) {
            throw InvalidInput.outside(
                    ValueProblem.FILE_UNUSABLE,
                    "crs",
                    WANTED,
                    "\"" + (written.length() > 60 ? written.substring(0, 60) + "…" : written)
                            + "\"; save the file in that system");
        }
    }
}
