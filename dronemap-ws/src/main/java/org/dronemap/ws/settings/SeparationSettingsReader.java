package org.dronemap.ws.settings;

import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.core.separation.Separation;
import org.dronemap.ws.environment.SetupException;

/** Reads from environment variables how far apart all drones in the air are kept. */
final class SeparationSettingsReader {
    private static final String GROUND = "DRONEMAP_SEPARATION_METERS";
    private static final String HEIGHT = "DRONEMAP_SEPARATION_HEIGHT_METERS";

    private SeparationSettingsReader() {}

    static Separation apart(Map<String, String> environment) {
        Stream.of(GROUND, HEIGHT).forEach(name -> refuseFormerName(environment, name));
        Separation otherwise = Separation.USUAL;
        return new Separation(
                meters(
                        environment,
                        GROUND,
                        otherwise.horizontalMeters(),
                        Separation.LEAST_HORIZONTAL_METERS,
                        Separation.MOST_HORIZONTAL_METERS),
                meters(
                        environment,
                        HEIGHT,
                        otherwise.verticalMeters(),
                        Separation.LEAST_VERTICAL_METERS,
                        Separation.MOST_VERTICAL_METERS));
    }

    /** Left unread, a wider distance that somebody had set would be gone in silence. */
    private static void refuseFormerName(Map<String, String> environment, String name) {
        String former = name.replace("DRONEMAP_", "DRONEMAP_FOLLOW_");
        if (!environment.getOrDefault(former, "").isBlank()) {
            throw new SetupException(former + " is now called " + name + ", and holds for all drones in the air.");
        }
    }

    private static double meters(
            Map<String, String> environment, String name, double otherwise, double least, double most) {
        String value = environment.getOrDefault(name, "").strip();
        if (value.isEmpty()) {
            return otherwise;
        }
        if (value.matches("\\d{1,3}(\\.\\d{1,3})?")) {
            double meters = Double.parseDouble(value);
            if (meters >= least && meters <= most) {
                return meters;
            }
        }
        throw new SetupException(
                String.format(Locale.ROOT, "%s must be %.0f to %.0f metres, not \"%s\".", name, least, most, value));
    }
}
