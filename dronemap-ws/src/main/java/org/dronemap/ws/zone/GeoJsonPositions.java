package org.dronemap.ws.zone;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/** Reads positions of GeoJSON, and remembers the heights that they have. Nothing (null) is left to who checks areas. */
final class GeoJsonPositions {
    /** Longitude, latitude, height, and a fourth number of measuring programs. */
    private static final int MOST_NUMBERS = 4;

    private final String field;
    private double lowest = Double.POSITIVE_INFINITY;
    private double highest = Double.NEGATIVE_INFINITY;

    GeoJsonPositions(String field) {
        this.field = field;
    }

    // AreaReader names what is nothing, with its field.
    @SuppressWarnings("NullAway")
    @Nullable
    List<List<List<Double>>> rings(JsonNode rings) {
        if (isNothing(rings)) {
            return null;
        }
        List<List<List<Double>>> read = new ArrayList<>();
        for (JsonNode ring : list(rings)) {
            List<List<Double>> positions = isNothing(ring) ? null : new ArrayList<>();
            if (positions != null) {
                for (JsonNode position : list(ring)) {
                    positions.add(position(position));
                }
            }
            read.add(positions);
        }
        return read;
    }

    @SuppressWarnings("NullAway")
    @Nullable
    List<Double> position(JsonNode position) {
        if (isNothing(position)) {
            return null;
        }
        List<Double> numbers = new ArrayList<>();
        for (JsonNode number : list(position)) {
            if (!number.isNumber() && !isNothing(number)) {
                throw malformed(number);
            }
            numbers.add(isNothing(number) ? null : number.doubleValue());
        }
        if (numbers.size() > MOST_NUMBERS) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED, field, "positions of longitude, latitude and height", numbers);
        }
        Double height = numbers.size() > 2 ? numbers.get(2) : null;
        if (height != null) {
            lowest = Math.min(lowest, height);
            highest = Math.max(highest, height);
        }
        return numbers;
    }

    private Iterable<JsonNode> list(JsonNode node) {
        if (!node.isArray()) {
            throw malformed(node);
        }
        return node;
    }

    private InvalidInput malformed(JsonNode node) {
        String written = node.toString();
        return InvalidInput.outside(
                ValueProblem.VALUE_MALFORMED,
                field,
                "rings of positions",
                written.length() > 40 ? written.substring(0, 40) + "…" : written);
    }

    private static boolean isNothing(JsonNode node) {
        return node.isNull() || node.isMissingNode();
    }

    /** Whether one of them is not 0. */
    boolean hasHeights() {
        return lowest <= highest && (lowest != 0 || highest != 0);
    }

    double lowest() {
        return lowest;
    }

    double highest() {
        return highest;
    }
}
