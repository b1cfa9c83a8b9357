package org.dronemap.mavlink.generator;

import java.util.Locale;

/** Turns MAVLink names with underscores into Java names, for the code generator. */
final class JavaNames {
    private JavaNames() {}

    /** {@code base_mode} is {@code baseMode}. */
    static String joined(String name) {
        StringBuilder joined = new StringBuilder();
        for (String word : name.split("_", -1)) {
            joined.append(joined.isEmpty() ? word : capitalised(word));
        }
        return joined.toString();
    }

    /** {@code SYS_STATUS} is {@code SysStatus}. */
    static String ofType(String name) {
        return capitalised(joined(name.toLowerCase(Locale.ROOT)));
    }

    private static String capitalised(String word) {
        return word.isEmpty() ? word : Character.toUpperCase(word.charAt(0)) + word.substring(1);
    }
}
