package org.dronemap.core.virtual;

import java.util.regex.Pattern;

/** Permanent id of a virtual drone; reveals nothing of the real drone that serves it. */
public record VirtualDroneId(String value) {
    private static final Pattern FORM = Pattern.compile("[a-z0-9-]{1,40}");

    public VirtualDroneId {
        if (!FORM.matcher(value).matches()) {
            throw new IllegalArgumentException("an id of a virtual drone is 1 to 40 of a-z, 0-9 and '-': " + value);
        }
    }

    @Override
    public String toString() {
        return value;
    }
}
