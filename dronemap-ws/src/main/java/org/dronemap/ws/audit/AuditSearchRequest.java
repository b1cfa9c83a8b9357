package org.dronemap.ws.audit;

import java.time.DateTimeException;
import java.time.Instant;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditQuery;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Search criteria for audit records; a null or empty one matches all. */
public record AuditSearchRequest(
        @Nullable String user,
        @Nullable String drone,
        @Nullable String operation,
        @Nullable String face,
        @Nullable String outcome,
        @Nullable String from,
        @Nullable String until) {
    /** {@code organisation}: whose records alone; null: all. */
    AuditQuery query(@Nullable String organisation) {
        return new AuditQuery(
                given(user),
                organisation,
                given(drone),
                given(operation),
                given(face),
                outcome(given(outcome)),
                time("from", given(from)),
                time("until", given(until)));
    }

    private static @Nullable String given(@Nullable String text) {
        return text == null || text.isBlank() ? null : text.strip();
    }

    private static @Nullable AuditOutcome outcome(@Nullable String name) {
        if (name == null) {
            return null;
        }
        return Arrays.stream(AuditOutcome.values())
                .filter(one -> WireNames.camel(one).equals(name))
                .findFirst()
                .orElseThrow(() -> InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED,
                        "outcome",
                        Arrays.stream(AuditOutcome.values())
                                .map(WireNames::camel)
                                .collect(Collectors.joining(", ")),
                        "\"" + name + "\""));
    }

    private static @Nullable Instant time(String field, @Nullable String text) {
        if (text == null) {
            return null;
        }
        try {
            return Instant.parse(text);
        } catch (DateTimeException e) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED, field, "a time such as 2026-03-04T05:06:07Z", "\"" + text + "\"");
        }
    }
}
