package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import org.jspecify.annotations.Nullable;

/** What people write about a flight. */
@Schema(name = "FlightNotes")
public record FlightNotes(@Nullable String notes) {
    private static final int LONGEST = 4_000;
    private static final String ALLOWED = "0 to " + LONGEST + " characters";

    String checked() {
        if (notes == null) {
            throw InvalidInput.missing("notes", ALLOWED);
        }
        if (notes.length() > LONGEST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "notes",
                    ALLOWED,
                    notes.length(),
                    ProblemParameter.LEAST.is(0),
                    ProblemParameter.MOST.is(LONGEST));
        }
        return notes;
    }
}
