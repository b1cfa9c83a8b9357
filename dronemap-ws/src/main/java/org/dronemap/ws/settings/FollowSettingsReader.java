package org.dronemap.ws.settings;

import java.util.Locale;
import java.util.Map;
import org.dronemap.cognitive.follow.FollowSeparation;
import org.dronemap.ws.environment.SetupException;

/** Reads from environment variables how far apart drones that follow phones must keep. */
final class FollowSettingsReader {
    private static final String GROUND = "DRONEMAP_FOLLOW_SEPARATION_METERS";
    private static final String HEIGHT = "DRONEMAP_FOLLOW_SEPARATION_HEIGHT_METERS";

    private FollowSettingsReader() {}

    static FollowSeparation apart(Map<String, String> environment) {
        FollowSeparation otherwise = FollowSeparation.USUAL;
        return new FollowSeparation(
                meters(
                        environment,
                        GROUND,
                        otherwise.groundMeters(),
                        FollowSeparation.LEAST_GROUND_METERS,
                        FollowSeparation.MOST_GROUND_METERS),
                meters(
                        environment,
                        HEIGHT,
                        otherwise.heightMeters(),
                        FollowSeparation.LEAST_HEIGHT_METERS,
                        FollowSeparation.MOST_HEIGHT_METERS));
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
