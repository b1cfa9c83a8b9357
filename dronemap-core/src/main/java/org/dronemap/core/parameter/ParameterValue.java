package org.dronemap.core.parameter;

import java.util.regex.Pattern;
import org.dronemap.core.stored.Stored;

/** A name and the value that a vehicle parameter is to be set to. */
@Stored(names = "name value")
public record ParameterValue(String name, double value) {
    /** What the name of a parameter looks like, as a regular expression. */
    public static final String NAME = "^[A-Za-z0-9_.-]{1,16}$";

    private static final Pattern NAMED = Pattern.compile(NAME);

    public ParameterValue {
        if (!isName(name)) {
            throw new IllegalArgumentException("a parameter's name is 1 to 16 of A-Z, a-z, 0-9, _ . and -: " + name);
        }
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("the value of " + name + " must be a finite number: " + value);
        }
    }

    public static boolean isName(String name) {
        return NAMED.matcher(name).matches();
    }

    /** For people: "RTL_ALT = 1500". */
    public String text() {
        return name + " = " + Parameter.text(ParameterType.REAL32, value);
    }
}
