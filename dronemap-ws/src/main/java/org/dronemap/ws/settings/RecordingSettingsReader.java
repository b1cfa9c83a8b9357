package org.dronemap.ws.settings;

import java.util.Locale;
import java.util.Map;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.environment.SetupException;

/** Reads the settings of recordings from the environment. */
final class RecordingSettingsReader {
    private static final String WHEN = "DRONEMAP_RECORD";
    private static final String MEGABYTES = "DRONEMAP_RECORD_MEGABYTES";
    private static final String DAYS = "DRONEMAP_RECORD_DAYS";
    private static final int MOST_MEGABYTES = 10_000_000;
    private static final int MOST_DAYS = 10_000;
    private static final long BYTES = 1_000_000;

    private RecordingSettingsReader() {}

    static RecordingPolicy of(Map<String, String> environment) {
        EnvironmentVariables variables = new EnvironmentVariables(environment);
        RecordingPolicy otherwise = RecordingPolicy.DEFAULT;
        return new RecordingPolicy(
                when(environment.getOrDefault(WHEN, "flights").strip()),
                variables.whole(MEGABYTES, 1, MOST_MEGABYTES, (int) (otherwise.mostBytes() / BYTES)) * BYTES,
                variables.whole(DAYS, 0, MOST_DAYS, otherwise.keepDays()));
    }

    private static RecordingPolicy.When when(String value) {
        return switch (value.toLowerCase(Locale.ROOT)) {
            case "", "flights" -> RecordingPolicy.When.FLIGHTS;
            case "always" -> RecordingPolicy.When.ALWAYS;
            case "never" -> RecordingPolicy.When.NEVER;
            default -> throw new SetupException(WHEN + " must be flights, always or never, not \"" + value + "\".");
        };
    }
}
