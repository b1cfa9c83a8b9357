package org.dronemap.ws.reading;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.ShapeValidator;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Turns a GeoJSON polygon or circle that a client wrote, for a zone or a key, into an area, or rejects the field. */
public final class AreaReader {
    public static final String SHAPES = "Polygon or Point";

    private static final String CORNERS =
            FenceArea.Polygon.LEAST_CORNERS + " to " + FenceArea.Polygon.MOST_CORNERS + " corners";
    /** Corners nearer than this are the same one, as {@link ShapeValidator} has it. */
    private static final double SAME_METERS = 0.01;

    private final String at;
    private final String radiusField;

    /** {@code at} is the name of the field that holds the geometry, such as {@code features[2].geometry}. */
    public AreaReader(String at, String radiusField) {
        this.at = at;
        this.radiusField = radiusField;
    }

    /** {@code rings}: of positions, longitude first. */
    public FenceArea polygon(boolean inside, @Nullable List<List<List<Double>>> rings) {
        return sound(new FenceArea.Polygon(inside, corners(rings)));
    }

    /** {@code radius}: in metres. */
    public FenceArea circle(boolean inside, @Nullable List<Double> middle, @Nullable Double radius) {
        return sound(new FenceArea.Circle(
                inside, position(at + ".coordinates", middle), FieldRanges.radius(radiusField, radius)));
    }

    private FenceArea sound(FenceArea shape) {
        Optional<String> fault = ShapeValidator.of(shape);
        if (fault.isPresent()) {
            throw new InvalidInput(ValueProblem.AREA_UNUSABLE, at, "a simple area", fault.get());
        }
        return shape;
    }

    private List<Geodetic> corners(@Nullable List<List<List<Double>>> written) {
        String field = at + ".coordinates";
        List<List<List<Double>>> rings = list(field, "one ring of positions", written);
        if (rings.isEmpty()) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, field, "one ring of positions", "none");
        }
        if (rings.size() != 1) {
            throw new InvalidInput(
                    ValueProblem.AREA_UNUSABLE,
                    field,
                    "one ring",
                    "An area with holes cannot be guarded as one; draw it in parts without holes.");
        }
        List<List<Double>> ring = list(field + "[0]", CORNERS, rings.get(0));
        List<Geodetic> corners = new ArrayList<>();
        for (int i = 0; i < ring.size(); i++) {
            corners.add(position(field + "[0][" + i + "]", ring.get(i)));
        }
        List<Geodetic> different = withoutRepetitions(corners);
        return counted(field, different);
    }

    /** A ring of GeoJSON ends where it began; programs also close it twice, or name a corner again. */
    private static List<Geodetic> withoutRepetitions(List<Geodetic> corners) {
        List<Geodetic> different = new ArrayList<>();
        for (Geodetic corner : corners) {
            if (different.isEmpty() || !isSame(different.get(different.size() - 1), corner)) {
                different.add(corner);
            }
        }
        while (different.size() > 1 && isSame(different.get(0), different.get(different.size() - 1))) {
            different.remove(different.size() - 1);
        }
        return different;
    }

    private static boolean isSame(Geodetic one, Geodetic other) {
        PlanePoint apart = LocalPlane.offset(one, other);
        return Math.hypot(apart.eastMeters(), apart.northMeters()) < SAME_METERS;
    }

    private static List<Geodetic> counted(String field, List<Geodetic> corners) {
        if (corners.size() < FenceArea.Polygon.LEAST_CORNERS || corners.size() > FenceArea.Polygon.MOST_CORNERS) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    field + "[0]",
                    CORNERS,
                    corners.size(),
                    ProblemParameter.LEAST.is(FenceArea.Polygon.LEAST_CORNERS),
                    ProblemParameter.MOST.is(FenceArea.Polygon.MOST_CORNERS));
        }
        return corners;
    }

    private static <T> List<T> list(String field, String allowed, @Nullable List<T> written) {
        if (written == null) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, field, allowed, "nothing");
        }
        return written;
    }

    private static Geodetic position(String field, @Nullable List<Double> written) {
        List<Double> numbers = list(field, "longitude and latitude", written);
        if (numbers.size() < 2) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, field, "longitude and latitude", numbers);
        }
        return new Geodetic(
                FieldRanges.latitude(field + "[1]", numbers.get(1)),
                FieldRanges.longitude(field + "[0]", numbers.get(0)));
    }
}
