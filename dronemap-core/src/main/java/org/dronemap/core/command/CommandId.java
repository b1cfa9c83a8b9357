package org.dronemap.core.command;

import java.util.regex.Pattern;
import org.dronemap.core.stored.Stored;

/** Unique id of a command, chosen by whoever gives it; the same id given twice acts once. */
@Stored(names = "value")
public record CommandId(String value) {
    private static final Pattern FORM = Pattern.compile("[A-Za-z0-9_-]{8,64}");

    public CommandId {
        if (!FORM.matcher(value).matches()) {
            throw new IllegalArgumentException("a command id is 8 to 64 of A-Z, a-z, 0-9, '_' and '-': " + value);
        }
    }

    @Override
    public String toString() {
        return value;
    }
}
