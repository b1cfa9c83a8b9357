package org.dronemap.ws.reading;

import org.dronemap.core.mission.Altitude;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Turns a floor and a ceiling that a client wrote, for a zone or a key, into an altitude band, or rejects the field.
 */
public final class AltitudeBandReader {
    private final String at;

    /** {@code at} is what stands before the names of fields, such as {@code properties.}. */
    public AltitudeBandReader(String at) {
        this.at = at;
    }

    public AltitudeBand band(@Nullable Double floor, @Nullable Double ceiling, @Nullable String measuredFrom) {
        Altitude.Reference reference = reference(measuredFrom);
        Double low = height("floor", floor);
        Double high = height("ceiling", ceiling);
        if (low != null && high != null && low >= high) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    at + "ceiling",
                    "above the floor of " + low + " m",
                    high,
                    ProblemParameter.LEAST.is(low),
                    ProblemParameter.UNIT.is("m"));
        }
        return new AltitudeBand(low, high, reference);
    }

    private Altitude.Reference reference(@Nullable String name) {
        return switch (name == null ? "home" : name) {
            case "home" -> Altitude.Reference.HOME;
            case "amsl" -> Altitude.Reference.AMSL;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, at + "altitudeReference", "home or amsl", "\"" + name + "\"");
        };
    }

    private @Nullable Double height(String field, @Nullable Double meters) {
        return meters == null ? null : Double.valueOf(FieldRanges.altitude(at + field, meters));
    }
}
