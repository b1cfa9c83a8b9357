package org.dronemap.ws.zone;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** One polygon of a KML file while it is read: its rings, the heights of its corners, and what is wrong with it. */
final class KmlPolygon {
    private static final Pattern BLANKS = Pattern.compile("\\s+");
    /** Some programs write a blank behind each comma of a corner. */
    private static final Pattern COMMA = Pattern.compile("\\s*,\\s*");
    /** Of these KML itself ignores the heights. */
    private static final Set<String> ON_THE_GROUND = Set.of("clampToGround", "clampToSeaFloor");

    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");
    private static final int NUMBERS = 3;

    private final String field;
    private final List<List<List<Double>>> rings = new ArrayList<>();
    private double lowest = Double.POSITIVE_INFINITY;
    private double highest = Double.NEGATIVE_INFINITY;
    private boolean onTheGround = true;
    private @Nullable InvalidInput fault;

    KmlPolygon(String field) {
        this.field = field;
    }

    void altitudeMode(String mode) {
        onTheGround = ON_THE_GROUND.contains(mode);
    }

    void ring(String written) {
        String stripped = written.strip();
        if (stripped.isEmpty()) {
            // Programs write a hole that is none.
            return;
        }
        List<List<Double>> ring = new ArrayList<>();
        for (String corner : BLANKS.split(COMMA.matcher(stripped).replaceAll(","), -1)) {
            ring.add(corner(corner));
        }
        rings.add(ring);
    }

    /** Of two or three numbers: with more a blank is missing, and a corner would be lost. */
    private List<Double> corner(String written) {
        String[] numbers = written.split(",", -1);
        try {
            if (numbers.length < 2 || numbers.length > NUMBERS) {
                throw malformed(written);
            }
            if (numbers.length == NUMBERS) {
                double height = number(numbers[2]);
                lowest = Math.min(lowest, height);
                highest = Math.max(highest, height);
            }
            return List.of(number(numbers[0]), number(numbers[1]));
        } catch (NumberFormatException e) {
            fault = fault == null ? malformed(written) : fault;
        } catch (InvalidInput e) {
            fault = fault == null ? e : fault;
        }
        return List.of();
    }

    /** Java reads more than numbers as files have them, such as {@code 9.1d}. */
    private static double number(String written) {
        if (!NUMBER.matcher(written).matches()) {
            throw new NumberFormatException(written);
        }
        return Double.parseDouble(written);
    }

    private InvalidInput malformed(String written) {
        String shown = written.length() > 60 ? written.substring(0, 60) + "…" : written;
        return InvalidInput.outside(
                ValueProblem.VALUE_MALFORMED,
                field,
                "corners of longitude,latitude or longitude,latitude,height, apart by blanks",
                "\"" + shown + "\"");
    }

    /** The outer one first, then those of holes, as GeoJSON has them. */
    List<List<List<Double>>> rings() {
        return rings;
    }

    @Nullable
    InvalidInput fault() {
        return fault;
    }

    boolean hasHeights() {
        return !onTheGround && lowest <= highest && (lowest != 0 || highest != 0);
    }

    double lowest() {
        return lowest;
    }

    double highest() {
        return highest;
    }
}
