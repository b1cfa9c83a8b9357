package org.dronemap.core.parameter;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.dronemap.core.parameter.ParameterFileContent.Reason;

/**
 * Reads parameter files as QGroundControl, Mission Planner, MAVProxy and ArduPilot write them: name and value in a line,
 * apart by a comma, an equals sign or blanks, or in the third and fourth of five columns apart by tabs, or by blanks
 * where an editor made those of them; the rest of a line after # is a remark. Whole numbers may be hexadecimal. Lines
 * that say something else are named, and the others count. Used once, by one thread.
 */
final class ParameterFileReader {
    private static final int TABLE_COLUMNS = 5;
    private static final int MOST_LINES = 20_000;
    private static final String AUTOPILOT = "1";
    private static final String MARK = "\uFEFF";
    private static final String READ_ONLY = "@READONLY";
    private static final Pattern APART = Pattern.compile("\\s*[,=]\\s*|\\s+");
    private static final Pattern BLANK_TABLE = Pattern.compile("\\d+\\s+\\d+\\s+\\S+\\s+\\S+\\s+\\d+");
    /** Java reads more than numbers as programs write them, such as {@code 15d}. */
    private static final Pattern DECIMAL = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

    private static final Pattern HEXADECIMAL = Pattern.compile("[+-]?0[xX][0-9a-fA-F]{1,13}");

    private final Map<String, ParameterValue> values = new LinkedHashMap<>();
    private final List<ParameterFileContent.LeftOut> leftOut = new ArrayList<>();

    private String vehicle = "";

    private ParameterFileReader() {}

    /** Files are UTF-8, or UTF-16 as some editors of Windows write them, with a mark that says so. */
    static String text(byte[] file) {
        boolean wide = file.length > 1 && ((file[0] & 0xFF) == 0xFE || (file[0] & 0xFF) == 0xFF);
        return new String(file, wide ? StandardCharsets.UTF_16 : StandardCharsets.UTF_8);
    }

    /** Throws {@link IllegalArgumentException} for a file that is too long. */
    static ParameterFileContent read(String text) {
        ParameterFileReader reader = new ParameterFileReader();
        int number = 0;
        String unmarked = text.startsWith(MARK) ? text.substring(MARK.length()) : text;
        for (String whole : unmarked.lines().toList()) {
            number++;
            if (number > MOST_LINES) {
                throw new IllegalArgumentException("the file has more than " + MOST_LINES + " lines");
            }
            int remark = whole.indexOf('#');
            String line = (remark < 0 ? whole : whole.substring(0, remark)).strip();
            if (!line.isEmpty()) {
                reader.line(line, number);
            }
        }
        return new ParameterFileContent(List.copyOf(reader.values.values()), reader.leftOut);
    }

    private void line(String line, int number) {
        String[] table = line.split(BLANK_TABLE.matcher(line).matches() ? "\\s+" : "\t", -1);
        if (table.length >= TABLE_COLUMNS) {
            row(table[0].strip(), table[1].strip(), table[2].strip(), table[3].strip(), number);
            return;
        }
        String[] pair = APART.split(line, -1);
        if (line.startsWith("@")) {
            leaveOut(
                    number,
                    Reason.INSTRUCTION,
                    "\"" + shortened(line) + "\" is an instruction, which is not followed.");
        } else if (pair.length == 3 && pair[2].equals(READ_ONLY)) {
            value(pair[0], pair[1], number);
        } else if (pair.length == 2) {
            value(pair[0], pair[1], number);
        } else {
            leaveOut(number, Reason.MALFORMED, "\"" + shortened(line) + "\" is no name with a value.");
        }
    }

    private void row(String system, String component, String name, String value, int number) {
        vehicle = vehicle.isEmpty() ? system : vehicle;
        if (!system.equals(vehicle)) {
            leaveOut(
                    number,
                    Reason.OTHER_VEHICLE,
                    shortened(name) + " is of vehicle " + shortened(system) + ", and the file begins with vehicle "
                            + shortened(vehicle) + ".");
        } else if (component.equals(AUTOPILOT)) {
            value(name, value, number);
        } else {
            leaveOut(
                    number,
                    Reason.OTHER_COMPONENT,
                    shortened(name) + " is of component " + shortened(component)
                            + ", not of the autopilot (component 1).");
        }
    }

    private void value(String name, String written, int number) {
        try {
            ParameterValue value = new ParameterValue(name, number(written));
            ParameterValue before = values.put(name, value);
            if (before != null && before.value() != value.value()) {
                leaveOut(
                        number,
                        Reason.REPEATED,
                        name + " comes again: " + written + " counts, and "
                                + Parameter.text(ParameterType.REAL64, before.value()) + " before does not.");
            }
        } catch (NumberFormatException e) {
            leaveOut(
                    number,
                    Reason.MALFORMED,
                    "The value of " + shortened(name) + ", \"" + shortened(written) + "\", is no number.");
        } catch (IllegalArgumentException e) {
            String why = String.valueOf(e.getMessage());
            leaveOut(number, Reason.MALFORMED, why.substring(0, 1).toUpperCase(Locale.ROOT) + why.substring(1) + ".");
        }
    }

    private static double number(String written) {
        if (HEXADECIMAL.matcher(written).matches()) {
            return Long.decode(written);
        }
        if (!DECIMAL.matcher(written).matches()) {
            throw new NumberFormatException(written);
        }
        return Double.parseDouble(written);
    }

    private void leaveOut(int line, Reason reason, String why) {
        leftOut.add(new ParameterFileContent.LeftOut(line, reason, why));
    }

    private static String shortened(String text) {
        return text.length() <= 40 ? text : text.substring(0, 40) + "…";
    }
}
