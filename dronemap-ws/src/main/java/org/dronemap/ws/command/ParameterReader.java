package org.dronemap.ws.command;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterFile;
import org.dronemap.core.parameter.ParameterFileContent;
import org.dronemap.core.parameter.ParameterSet;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Checks parameter values that a client wants to set on a vehicle against the vehicle's known parameters. */
public final class ParameterReader {
    private static final String NAMES = "1 to 16 of A-Z, a-z, 0-9, _ . and -";
    private static final String COUNT = "1 to 10000 parameters";
    static final int MOST = 10_000;

    private ParameterReader() {}

    static List<ParameterValue> read(
            @Nullable List<VehicleDataRequest.ParameterRequest> written, ParameterSet vehicle) {
        if (written == null || written.isEmpty()) {
            throw InvalidInput.missing("parameters", COUNT);
        }
        if (written.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "parameters",
                    COUNT,
                    written.size(),
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST));
        }
        List<ParameterValue> values = new ArrayList<>(written.size());
        for (int index = 0; index < written.size(); index++) {
            VehicleDataRequest.ParameterRequest one = written.get(index);
            String at = "parameters[" + index + "].";
            values.add(checked(at + "name", one.name(), at + "value", one.value(), vehicle));
        }
        return values;
    }

    public static ParameterValue checked(
            String nameField, @Nullable String name, String valueField, @Nullable Double value, ParameterSet vehicle) {
        if (name == null) {
            throw InvalidInput.missing(nameField, NAMES);
        }
        if (!ParameterValue.isName(name)) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, nameField, NAMES, "\"" + name + "\"");
        }
        if (value == null || !Double.isFinite(value)) {
            throw InvalidInput.missing(valueField, "a number");
        }
        Parameter held = vehicle.find(name).orElse(null);
        if (held == null && vehicle.readAt() != null) {
            throw InvalidInput.outside(
                    ValueProblem.REFERENCE_UNKNOWN, nameField, "a parameter that the vehicle has", "\"" + name + "\"");
        }
        if (held != null && !held.type().holds(value)) {
            throw InvalidInput.outside(ValueProblem.VALUE_OUT_OF_RANGE, valueField, range(held.type()), value);
        }
        return new ParameterValue(name, value);
    }

    private static String range(ParameterType type) {
        return type.decimal() ? "a number" : "a whole number from " + (long) type.least() + " to " + (long) type.most();
    }

    public static ParameterFileContent file(String text) {
        try {
            ParameterFileContent content = ParameterFile.read(text);
            List<ParameterValue> values = content.values();
            if (values.isEmpty() && !content.leftOut().isEmpty()) {
                ParameterFileContent.LeftOut first = content.leftOut().get(0);
                throw new InvalidInput(
                        ValueProblem.FILE_UNUSABLE,
                        "file",
                        "lines such as RTL_ALT,1500",
                        "There is no value for the autopilot in this file. Line " + first.line() + ": " + first.why());
            }
            if (values.isEmpty() || values.size() > MOST) {
                throw InvalidInput.outside(
                        ValueProblem.SIZE_OUT_OF_RANGE,
                        "file",
                        COUNT,
                        values.size(),
                        ProblemParameter.LEAST.is(1),
                        ProblemParameter.MOST.is(MOST));
            }
            return content;
        } catch (IllegalArgumentException e) {
            throw new InvalidInput(
                    ValueProblem.FILE_UNUSABLE,
                    "file",
                    "lines such as RTL_ALT,1500",
                    "The file cannot be used: " + e.getMessage() + ".");
        }
    }
}
