package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Notes that people write about a flight. */
@Schema(name = "FlightNotes")
record FlightNotes(
        @Size(max = FlightNotes.LONGEST) @Nullable String notes) {
    static final int LONGEST = 4_000;
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
