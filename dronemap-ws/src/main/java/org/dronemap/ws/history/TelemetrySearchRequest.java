package org.dronemap.ws.history;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TimeRange;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.reading.WireTimes;
import org.jspecify.annotations.Nullable;

/**
 * Time span, fields and resolution of stored telemetry, as query parameters of REST; a null or empty one: the default.
 *
 * @param fields names with commas between them
 * @param slots in how many the time is cut
 * @param most points at most
 */
public record TelemetrySearchRequest(
        @Nullable String from,
        @Nullable String until,
        @Nullable String fields,
        @Nullable String slots,
        @Nullable String most) {
    private static final Duration LONGEST = Duration.ofDays(31);
    private static final int USUAL_SLOTS = 1_000;
    private static final int MOST_SLOTS = 5_000;
    private static final int USUAL_POINTS = 5_000;
    private static final int MOST_POINTS = 20_000;
    private static final List<TelemetryField> USUAL_FIELDS = List.of(
            TelemetryField.ALTITUDE_ABOVE_HOME,
            TelemetryField.GROUND_SPEED,
            TelemetryField.BATTERY_PERCENT,
            TelemetryField.LOSS_SHORT);

    TimeRange span(TimeRange usual) {
        Instant begin = WireTimes.read("from", from);
        Instant end = WireTimes.read("until", until);
        Instant first = begin == null ? usual.from() : begin;
        Instant last = end == null ? usual.until() : end;
        if (last.isBefore(first)) {
            throw InvalidInput.outside(ValueProblem.VALUE_OUT_OF_RANGE, "until", "a time after " + first, last);
        }
        if (Duration.between(first, last).compareTo(LONGEST) > 0) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE, "from", "a time at most 31 days before " + last, first);
        }
        return new TimeRange(first, last);
    }

    List<TelemetryField> chosen() {
        if (fields == null || fields.isBlank()) {
            return USUAL_FIELDS;
        }
        return Arrays.stream(fields.split(",", -1))
                .map(String::strip)
                .map(TelemetrySearchRequest::named)
                .distinct()
                .toList();
    }

    private static TelemetryField named(String name) {
        return Arrays.stream(TelemetryField.values())
                .filter(field -> WireNames.camel(field).equals(name))
                .findFirst()
                .orElseThrow(() -> InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED,
                        "fields",
                        "some of "
                                + Arrays.stream(TelemetryField.values())
                                        .map(WireNames::camel)
                                        .collect(Collectors.joining(", ")),
                        "\"" + name + "\""));
    }

    int slotCount() {
        return bounded("slots", slots, USUAL_SLOTS, MOST_SLOTS);
    }

    int mostPoints() {
        return bounded("most", most, USUAL_POINTS, MOST_POINTS);
    }

    private static int bounded(String field, @Nullable String value, int usual, int most) {
        if (value == null || value.isBlank()) {
            return usual;
        }
        if (value.matches("\\d{1,6}")) {
            int number = Integer.parseInt(value);
            if (number >= 1 && number <= most) {
                return number;
            }
        }
        throw InvalidInput.outside(
                ValueProblem.VALUE_OUT_OF_RANGE,
                field,
                "1 to " + most,
                "\"" + value + "\"",
                ProblemParameter.LEAST.is(1),
                ProblemParameter.MOST.is(most));
    }
}
