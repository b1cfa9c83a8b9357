package org.dronemap.core.parameter;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Reads and writes parameter files of QGroundControl, Mission Planner and MAVProxy. */
public final class ParameterFile {
    /** Format of a parameter file: comma-separated list (Mission Planner, MAVProxy) or QGroundControl table. */
    public enum Form {
        /** Name and value apart by a comma: Mission Planner, MAVProxy. */
        LIST,
        /** Vehicle, component, name, value and type apart by tabs: QGroundControl. */
        TABLE
    }

    private ParameterFile() {}

    /**
     * Reads a file; a name that comes twice has its last value, and what is left out is named.
     *
     * @throws IllegalArgumentException when it is too long
     */
    public static ParameterFileContent read(String text) {
        return ParameterFileReader.read(text);
    }

    /** The text of a file, in the encoding that it has. */
    public static String text(byte[] file) {
        return ParameterFileReader.text(file);
    }

    /** Writes parameters for a vehicle of that number (it matters only to the table form). */
    public static String write(List<Parameter> parameters, Form form, int vehicle) {
        List<String> lines = new ArrayList<>();
        if (form == Form.TABLE) {
            lines.add("# Onboard parameters for Vehicle " + vehicle);
            lines.add("#");
            lines.add("# Vehicle-Id Component-Id Name Value Type");
        }
        for (Parameter parameter : parameters) {
            lines.add(
                    form == Form.LIST
                            ? parameter.name() + "," + parameter.text()
                            : String.join(
                                    "\t",
                                    Integer.toString(vehicle),
                                    "1",
                                    parameter.name(),
                                    tableValue(parameter),
                                    Integer.toString(parameter.type().fileNumber())));
        }
        return String.join("\n", lines) + "\n";
    }

    private static String tableValue(Parameter parameter) {
        return parameter.type().decimal() ? String.format(Locale.ROOT, "%.18f", parameter.value()) : parameter.text();
    }
}
