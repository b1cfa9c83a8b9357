package org.dronemap.sim.load;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The command line of a load test program, as {@code --name value} pairs. */
final class LoadArguments {
    private final Map<String, String> values = new HashMap<>();

    LoadArguments(List<String> words) {
        for (int i = 0; i + 1 < words.size(); i += 2) {
            values.put(words.get(i), words.get(i + 1));
        }
        if (words.size() % 2 != 0) {
            throw new IllegalArgumentException(words.get(words.size() - 1) + " needs a value");
        }
    }

    String text(String name) {
        String value = values.get(name);
        if (value == null) {
            throw new IllegalArgumentException(name + " is missing");
        }
        return value;
    }

    String text(String name, String otherwise) {
        return values.getOrDefault(name, otherwise);
    }

    int integer(String name) {
        return Math.toIntExact(longInteger(name));
    }

    long longInteger(String name) {
        try {
            return Long.parseLong(text(name));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(name + " wants a whole number, not '" + text(name) + "'", e);
        }
    }

    double number(String name, double otherwise) {
        String value = values.get(name);
        try {
            return value == null ? otherwise : Double.parseDouble(value);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(name + " wants a number, not '" + value + "'", e);
        }
    }
}
