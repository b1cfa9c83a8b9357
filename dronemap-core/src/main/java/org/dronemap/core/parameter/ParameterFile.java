package org.dronemap.core.parameter;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Reads and writes parameter files of QGroundControl, Mission Planner and MAVProxy. Reads what QGroundControl, Mission
 * Planner and MAVProxy write: name and value in a line, apart by a comma or blanks, or in the third and fourth of five
 * columns apart by tabs; the rest of a line after # is a remark.
 */
public final class ParameterFile {
    /** Format of a parameter file: comma-separated list (Mission Planner, MAVProxy) or QGroundControl table. */
    public enum Form {
        /** Name and value apart by a comma: Mission Planner, MAVProxy. */
        LIST,
        /** Vehicle, component, name, value and type apart by tabs: QGroundControl. */
        TABLE
    }

    private static final int TABLE_COLUMNS = 5;
    private static final int MOST_LINES = 20_000;

    private ParameterFile() {}

    /**
     * Reads a file; a name that comes twice has its last value.
     *
     * @throws IllegalArgumentException with the number of the line that is wrong, and why
     */
    public static List<ParameterValue> read(String text) {
        Map<String, ParameterValue> values = new LinkedHashMap<>();
        int number = 0;
        for (String whole : text.lines().toList()) {
            number++;
            int remark = whole.indexOf('#');
            String line = (remark < 0 ? whole : whole.substring(0, remark)).strip();
            if (number > MOST_LINES) {
                throw new IllegalArgumentException("the file has more than " + MOST_LINES + " lines");
            }
            if (!line.isEmpty()) {
                ParameterValue value = line(line, number);
                values.put(value.name(), value);
            }
        }
        return List.copyOf(values.values());
    }

    private static ParameterValue line(String line, int number) {
        String[] table = line.split("\t", -1);
        String[] pair = table.length >= TABLE_COLUMNS
                ? new String[] {table[2], table[3]}
                : line.split(line.contains(",") ? "," : "\\s+", -1);
        if (pair.length != 2) {
            throw new IllegalArgumentException(
                    "line " + number + " is no name with a value: \"" + shortened(line) + "\"");
        }
        try {
            return new ParameterValue(pair[0].strip(), Double.parseDouble(pair[1].strip()));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    "line " + number + ": \"" + shortened(pair[1].strip()) + "\" is no number", e);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("line " + number + ": " + e.getMessage(), e);
        }
    }

    private static String shortened(String text) {
        return text.length() <= 40 ? text : text.substring(0, 40) + "…";
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
