package org.dronemap.core.drone;

import java.util.regex.Pattern;
import org.dronemap.core.stored.Stored;

/** The cloud's durable name of a drone; survives address changes and restarts. */
@Stored(names = "value")
public record DroneId(String value) {
    private static final Pattern FORM = Pattern.compile("[a-z0-9-]{1,40}");

    public DroneId {
        if (!FORM.matcher(value).matches()) {
            throw new IllegalArgumentException("a drone id is 1 to 40 of a-z, 0-9 and '-': " + value);
        }
    }

    @Override
    public String toString() {
        return value;
    }
}
