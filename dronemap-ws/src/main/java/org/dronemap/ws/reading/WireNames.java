package org.dronemap.ws.reading;

import java.util.Locale;
import java.util.concurrent.ConcurrentHashMap;

/** Turns names of Java enum constants and types into the camel-case names that clients see. */
public final class WireNames {
    private static final ConcurrentHashMap<Enum<?>, String> CAMEL = new ConcurrentHashMap<>();

    private WireNames() {}

    /** {@code TAKING_OFF} becomes {@code takingOff}. */
    public static String camel(Enum<?> constant) {
        String known = CAMEL.get(constant);
        return known != null ? known : CAMEL.computeIfAbsent(constant, WireNames::toCamel);
    }

    private static String toCamel(Enum<?> constant) {
        StringBuilder text = new StringBuilder();
        boolean upper = false;
        for (char letter : constant.name().toCharArray()) {
            if (letter == '_') {
                upper = true;
            } else {
                text.append(upper ? letter : Character.toLowerCase(letter));
                upper = false;
            }
        }
        return text.toString();
    }

    /** {@code TakeOff} becomes {@code takeOff}. */
    public static String lowerFirst(String name) {
        return name.substring(0, 1).toLowerCase(Locale.ROOT) + name.substring(1);
    }
}
