package org.dronemap.ws.environment;

import java.util.Map;

/** Reads settings of the server from environment variables such as {@code DRONEMAP_STREAMS_PER_USER}. Immutable. */
public final class EnvironmentVariables {
    private static final String WHOLE = "-?\\d{1,9}";

    private final Map<String, String> texts;

    public EnvironmentVariables(Map<String, String> environment) {
        texts = Map.copyOf(environment);
    }

    /** A whole number, both bounds included; {@code otherwise} where it is not set. */
    public int whole(String name, int least, int most, int otherwise) {
        String value = texts.getOrDefault(name, "").strip();
        if (value.isEmpty()) {
            return otherwise;
        }
        if (value.matches(WHOLE)) {
            int number = Integer.parseInt(value);
            if (number >= least && number <= most) {
                return number;
            }
        }
        throw new SetupException(
                name + " must be a whole number from " + least + " to " + most + ", not \"" + value + "\".");
    }
}
