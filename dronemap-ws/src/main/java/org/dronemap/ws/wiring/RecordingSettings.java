package org.dronemap.ws.wiring;

import java.util.Locale;
import java.util.Map;
import org.dronemap.core.recording.RecordingPolicy;

/** What the environment says about recordings. */
final class RecordingSettings {
    private static final String WHEN = "DRONEMAP_RECORD";
    private static final String MEGABYTES = "DRONEMAP_RECORD_MEGABYTES";
    private static final String DAYS = "DRONEMAP_RECORD_DAYS";
    private static final long MOST_MEGABYTES = 10_000_000;
    private static final long MOST_DAYS = 10_000;
    private static final long BYTES = 1_000_000;

    private RecordingSettings() {}

    static RecordingPolicy of(Map<String, String> environment) {
        RecordingPolicy otherwise = RecordingPolicy.DEFAULT;
        return new RecordingPolicy(
                when(environment.getOrDefault(WHEN, "flights").strip()),
                number(environment, MEGABYTES, otherwise.mostBytes() / BYTES, 1, MOST_MEGABYTES) * BYTES,
                (int) number(environment, DAYS, otherwise.keepDays(), 0, MOST_DAYS));
    }

    private static RecordingPolicy.When when(String value) {
        return switch (value.toLowerCase(Locale.ROOT)) {
            case "", "flights" -> RecordingPolicy.When.FLIGHTS;
            case "always" -> RecordingPolicy.When.ALWAYS;
            case "never" -> RecordingPolicy.When.NEVER;
            default -> throw new SetupException(WHEN + " must be flights, always or never, not \"" + value + "\".");
        };
    }

    private static long number(Map<String, String> environment, String name, long otherwise, long least, long most) {
        String value = environment.getOrDefault(name, "").strip();
        if (value.isEmpty()) {
            return otherwise;
        }
        if (value.matches("\\d{1,9}")) {
            long number = Long.parseLong(value);
            if (number >= least && number <= most) {
                return number;
            }
        }
        throw new SetupException(
                name + " must be a whole number from " + least + " to " + most + ", not \"" + value + "\".");
    }
}
