package org.dronemap.ws.settings;

import java.time.Duration;
import java.util.Map;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.history.Retention;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.environment.SetupException;

/** Reads the settings of the drones' history from the environment. */
final class HistorySettingsReader {
    private static final String RATE = "DRONEMAP_TELEMETRY_RATE";
    private static final String FULL_DAYS = "DRONEMAP_TELEMETRY_FULL_DAYS";
    private static final String DAYS = "DRONEMAP_TELEMETRY_DAYS";
    private static final double LEAST_RATE = 0.1;
    private static final double MOST_RATE = 50;
    private static final int MOST_DAYS = 10_000;

    private HistorySettingsReader() {}

    static HistoryPolicy of(Map<String, String> environment) {
        EnvironmentVariables variables = new EnvironmentVariables(environment);
        HistoryPolicy otherwise = HistoryPolicy.DEFAULT;
        Duration flying = flying(environment, otherwise.flying());
        Duration resting = flying.compareTo(otherwise.resting()) > 0 ? flying : otherwise.resting();
        Retention usual = otherwise.retention();
        return new HistoryPolicy(
                flying,
                resting,
                new Retention(
                        variables.whole(FULL_DAYS, 0, MOST_DAYS, usual.fullDays()),
                        variables.whole(DAYS, 0, MOST_DAYS, usual.keepDays()),
                        usual.thinned()));
    }

    private static Duration flying(Map<String, String> environment, Duration otherwise) {
        String value = environment.getOrDefault(RATE, "").strip();
        if (value.isEmpty()) {
            return otherwise;
        }
        if (value.matches("\\d{1,3}(\\.\\d{1,3})?")) {
            double rate = Double.parseDouble(value);
            if (rate >= LEAST_RATE && rate <= MOST_RATE) {
                return Duration.ofNanos(Math.round(1e9 / rate));
            }
        }
        throw new SetupException(RATE + " must be a number from 0.1 to 50 (states a second), not \"" + value + "\".");
    }
}
