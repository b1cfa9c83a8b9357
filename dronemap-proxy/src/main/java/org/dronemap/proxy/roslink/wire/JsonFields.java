package org.dronemap.proxy.roslink.wire;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/** Reads JSON fields leniently, as ROSLink bridges fill them: numbers as strings, missing, null or not finite. */
record JsonFields(JsonNode object) {
    private static final int LONGEST_TEXT = 64;
    private static final double LARGEST_WHOLE = 1L << 53;

    /** The object of that name; null when there is none. */
    @Nullable
    JsonFields inner(String name) {
        JsonNode node = object.get(name);
        return node != null && node.isObject() ? new JsonFields(node) : null;
    }

    boolean has(String name) {
        return object.hasNonNull(name);
    }

    @Nullable
    Double number(String name) {
        return number(object.get(name));
    }

    private static @Nullable Double number(@Nullable JsonNode node) {
        double value = Double.NaN;
        if (node != null && node.isNumber()) {
            value = node.doubleValue();
        } else if (node != null && node.isString() && node.stringValue().length() <= LONGEST_TEXT) {
            value = parsed(node.stringValue().strip());
        }
        return Double.isFinite(value) ? value : null;
    }

    private static double parsed(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    /** A number without a fraction; null for any other. */
    @Nullable
    Long whole(String name) {
        Double value = number(name);
        return value == null || Math.rint(value) != value || Math.abs(value) > LARGEST_WHOLE ? null : value.longValue();
    }

    /** A whole number from 0 to {@code most}; null for any other. */
    @Nullable
    Integer count(String name, int most) {
        Long value = whole(name);
        return value == null || value < 0 || value > most ? null : value.intValue();
    }

    /** A whole number of ordinary size, negative or not; null for any other. */
    @Nullable
    Integer code(String name) {
        Long value = whole(name);
        return value == null || Math.abs(value) > Integer.MAX_VALUE ? null : value.intValue();
    }

    /** A short text without control characters; null when there is none. */
    @Nullable
    String text(String name) {
        StringOrNumber word = word(name);
        return word == null ? null : word.text();
    }

    /** A string or a number, 1 to 64 printable characters; null for anything else. */
    @Nullable
    StringOrNumber word(String name) {
        JsonNode node = object.get(name);
        if (node == null) {
            return null;
        }
        if (node.isNumber()) {
            Long whole = whole(name);
            return whole == null ? null : new StringOrNumber(whole.toString(), true);
        }
        String text = node.isString() ? node.stringValue().strip() : "";
        boolean fits =
                !text.isEmpty() && text.length() <= LONGEST_TEXT && text.chars().noneMatch(Character::isISOControl);
        return fits ? new StringOrNumber(text, false) : null;
    }

    /** A string of any length; null when there is none. */
    @Nullable
    String data(String name) {
        JsonNode node = object.get(name);
        return node != null && node.isString() && !node.stringValue().isEmpty() ? node.stringValue() : null;
    }

    /** The numbers of an array, null where one is no finite number; those after {@code most} are left out. */
    List<@Nullable Double> numbers(String name, int most) {
        JsonNode node = object.get(name);
        List<@Nullable Double> numbers = new ArrayList<>();
        if (node != null && node.isArray()) {
            for (int index = 0; index < Math.min(node.size(), most); index++) {
                numbers.add(number(node.get(index)));
            }
        }
        return numbers;
    }
}
