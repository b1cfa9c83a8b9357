package org.dronemap.ws.settings;

import java.util.Locale;
import java.util.Map;
import org.dronemap.cognitive.follow.Apart;
import org.dronemap.ws.setting.SetupException;

/** Reads the separation of following drones from the environment. */
final class FollowSettings {
    private static final String GROUND = "DRONEMAP_FOLLOW_SEPARATION_METERS";
    private static final String HEIGHT = "DRONEMAP_FOLLOW_SEPARATION_HEIGHT_METERS";

    private FollowSettings() {}

    static Apart apart(Map<String, String> environment) {
        Apart otherwise = Apart.USUAL;
        return new Apart(
                meters(
                        environment,
                        GROUND,
                        otherwise.groundMeters(),
                        Apart.LEAST_GROUND_METERS,
                        Apart.MOST_GROUND_METERS),
                meters(
                        environment,
                        HEIGHT,
                        otherwise.heightMeters(),
                        Apart.LEAST_HEIGHT_METERS,
                        Apart.MOST_HEIGHT_METERS));
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
