package org.dronemap.core.operation;

import java.util.regex.Pattern;
import org.dronemap.core.stored.Stored;

/** Permanent id of an operation: 1 to 64 letters, digits, dots, dashes and underscores. */
@Stored(names = "value")
public record OperationId(String value) {
    private static final Pattern FORM = Pattern.compile("[A-Za-z0-9._-]{1,64}");

    public OperationId {
        if (!FORM.matcher(value).matches()) {
            throw new IllegalArgumentException("not an id of an operation: " + value);
        }
    }

    @Override
    public String toString() {
        return value;
    }
}
