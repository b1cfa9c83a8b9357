package org.dronemap.ws.zone;

import java.util.Optional;
import java.util.regex.Pattern;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Name of a zone from a file: one line, a fallback where there is none, with a number where one piece becomes several
 * zones.
 */
record ZoneFileName(String whole) {
    private static final Pattern BLANK = Pattern.compile("[\\s\\p{Cntrl}]+");
    /** Half a letter, and what is none: XML cannot carry them. */
    private static final Pattern NO_TEXT = Pattern.compile("[\\p{Cs}\\uFFFE\\uFFFF]");

    static ZoneFileName of(@Nullable String given, String fallback) {
        String line = given == null
                ? ""
                : BLANK.matcher(NO_TEXT.matcher(given).replaceAll("?"))
                        .replaceAll(" ")
                        .strip();
        return new ZoneFileName(line.isEmpty() ? fallback : line);
    }

    /** As a zone can have it; {@code number}: 0 where it is the only one. */
    String numbered(int number) {
        String end = number == 0 ? "" : " (" + number + ")";
        int room = ZoneReader.LONGEST_NAME - end.length();
        return (whole.length() <= room ? whole : whole.substring(0, room - 1) + "…") + end;
    }

    /** What is left out of it. */
    Optional<InvalidInput> cut(String at) {
        return whole.length() <= ZoneReader.LONGEST_NAME
                ? Optional.empty()
                : Optional.of(new InvalidInput(
                        ValueProblem.SIZE_OUT_OF_RANGE,
                        at,
                        "1 to " + ZoneReader.LONGEST_NAME + " characters",
                        "Its name has " + whole.length() + " characters; the first " + (ZoneReader.LONGEST_NAME - 1)
                                + " are taken."));
    }
}
