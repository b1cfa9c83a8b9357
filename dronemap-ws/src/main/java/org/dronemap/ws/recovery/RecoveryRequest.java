package org.dronemap.ws.recovery;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.util.List;
import org.dronemap.cognitive.operation.recovery.RecoveryManner;
import org.dronemap.cognitive.operation.recovery.RecoveryOrder;
import org.dronemap.core.separation.Separation;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** Request to bring several drones home, or down, as a client writes it. Nothing is checked yet. */
@Schema(name = "RecoveryRequest", description = "Which drones come home, or down, and within which heights.")
public record RecoveryRequest(
        @Schema(
                description = "return: each to its home, at a height of its own; land: each where it is",
                requiredMode = Schema.RequiredMode.REQUIRED)
        @EnumValues(RecoveryManner.class)
        @Nullable
        String manner,

        @Schema(description = "Ids of drones; left out: all in the air that you may command") @Nullable
        List<@Nullable String> drones,

        @Schema(description = "metres above each drone's home, 5 to 500: none flies home below; left out: 20")
        @Min((int) RecoveryOrder.LEAST_METERS)
        @Max((int) RecoveryOrder.MOST_METERS)
        @Nullable
        Double lowest,

        @Schema(description = "metres above each drone's home, 5 to 500: none flies home above; left out: 120")
        @Min((int) RecoveryOrder.LEAST_METERS)
        @Max((int) RecoveryOrder.MOST_METERS)
        @Nullable
        Double ceiling,

        @Schema(
                description =
                        "true: also drones that operations of yours have, which end by that, and those that a pilot at the"
                                + " vehicle has; for a supervisor those that others have, too. Else they are left out and named")
        @Nullable
        Boolean takeOver,

        @Schema(
                description =
                        "Ids of the drones that a preview showed to come: refused with what has changed if others would come"
                                + " now; left out: it begins with whoever is in the air. A preview does not look at it")
        @Nullable
        List<@Nullable String> previewed) {

    RecoveryOrder order(Separation least) {
        double low = meters("lowest", lowest, RecoveryOrder.USUAL_LOWEST_METERS);
        double high = meters("ceiling", ceiling, RecoveryOrder.USUAL_CEILING_METERS);
        if (high < low) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "ceiling",
                    "at least as high as lowest",
                    high,
                    ProblemParameter.LEAST.is(low),
                    ProblemParameter.MOST.is(RecoveryOrder.MOST_METERS),
                    ProblemParameter.UNIT.is("m"));
        }
        return RecoveryOrder.of(readManner(), low, high, least);
    }

    private RecoveryManner readManner() {
        if (manner == null) {
            throw InvalidInput.missing("manner", "return or land");
        }
        return switch (manner) {
            case "return" -> RecoveryManner.RETURN;
            case "land" -> RecoveryManner.LAND;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "manner", "return or land", "\"" + manner + "\"");
        };
    }

    private static double meters(String field, @Nullable Double value, double usual) {
        return FieldRanges.checked(
                field,
                value == null ? (Double) usual : value,
                (int) RecoveryOrder.LEAST_METERS,
                (int) RecoveryOrder.MOST_METERS,
                "m");
    }

    boolean isTakeOver() {
        return Boolean.TRUE.equals(takeOver);
    }
}
