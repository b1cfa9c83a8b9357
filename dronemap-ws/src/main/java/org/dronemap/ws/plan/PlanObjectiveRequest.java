package org.dronemap.ws.plan;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** Objective of a plan as a client writes it; one record for each kind. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "kind")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = PlanObjectiveRequest.EarliestEnd.class, name = "earliestEnd"),
    @JsonSubTypes.Type(value = PlanObjectiveRequest.LeastTime.class, name = "leastTime"),
    @JsonSubTypes.Type(value = PlanObjectiveRequest.LeastDistance.class, name = "leastDistance"),
    @JsonSubTypes.Type(value = PlanObjectiveRequest.LeastEnergy.class, name = "leastEnergy"),
    @JsonSubTypes.Type(value = PlanObjectiveRequest.Weighted.class, name = "weighted")
})
@Schema(
        name = "PlanObjectiveRequest",
        description = "What the plan is to be good at; which members there are depends on the kind.")
public sealed interface PlanObjectiveRequest {
    @Schema(description = "Whether each drone must fly; left out: drones may stay where they are")
    @Nullable
    Boolean everyDrone();

    /**
     * Throws {@link InvalidInput} where a member cannot be used.
     *
     * @param at what stands before its members' names, such as {@code objective.}
     */
    Objective read(String at);

    /** All is done as early as can be. */
    @Schema(name = "PlanEarliestEndObjective", description = "All is done as early as can be.")
    record EarliestEnd(@Nullable Boolean everyDrone) implements PlanObjectiveRequest {
        @Override
        public Objective read(String at) {
            return new Objective(1, Objective.Measure.SECONDS, 0, Boolean.TRUE.equals(everyDrone));
        }
    }

    /** All tours together take as little time as can be. */
    @Schema(name = "PlanLeastTimeObjective", description = "All tours together take as little time as can be.")
    record LeastTime(@Nullable Boolean everyDrone) implements PlanObjectiveRequest {
        @Override
        public Objective read(String at) {
            return new Objective(0, Objective.Measure.SECONDS, 1, Boolean.TRUE.equals(everyDrone));
        }
    }

    /** All tours together are as short as can be. */
    @Schema(name = "PlanLeastDistanceObjective", description = "All tours together are as short as can be.")
    record LeastDistance(@Nullable Boolean everyDrone) implements PlanObjectiveRequest {
        @Override
        public Objective read(String at) {
            return new Objective(0, Objective.Measure.METERS, 1, Boolean.TRUE.equals(everyDrone));
        }
    }

    /** All tours together take as little energy as can be. */
    @Schema(name = "PlanLeastEnergyObjective", description = "All tours together take as little energy as can be.")
    record LeastEnergy(@Nullable Boolean everyDrone) implements PlanObjectiveRequest {
        @Override
        public Objective read(String at) {
            return new Objective(0, Objective.Measure.JOULES, 1, Boolean.TRUE.equals(everyDrone));
        }
    }

    /** The longest tour and the sum over all, each with a weight. */
    @Schema(name = "PlanWeightedObjective", description = "The longest tour and the sum over all tours, by weights.")
    record Weighted(
            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Of the longest tour's seconds, 0 to 1000000")
            @Min(0)
            @Max(Weighted.HEAVIEST)
            @Nullable
            Double longestWeight,

            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Of the sum over all tours, 0 to 1000000; above 0 where longestWeight is 0")
            @Min(0)
            @Max(Weighted.HEAVIEST)
            @Nullable
            Double sumWeight,

            @Schema(description = "What is summed; left out: seconds") @EnumValues(Objective.Measure.class) @Nullable
            String measure,

            @Nullable Boolean everyDrone)
            implements PlanObjectiveRequest {
        static final int HEAVIEST = 1_000_000;
        private static final String MEASURES = "seconds, meters or joules";

        @Override
        public Objective read(String at) {
            double longest = FieldRanges.checked(at + "longestWeight", longestWeight, 0, HEAVIEST, "as a weight");
            double sum = FieldRanges.checked(at + "sumWeight", sumWeight, 0, HEAVIEST, "as a weight");
            if (longest == 0 && sum == 0) {
                throw InvalidInput.outside(
                        ValueProblem.VALUE_OUT_OF_RANGE, at + "sumWeight", "above 0 where longestWeight is 0", sum);
            }
            return new Objective(longest, measure(at), sum, Boolean.TRUE.equals(everyDrone));
        }

        private Objective.Measure measure(String at) {
            return switch (measure == null ? "seconds" : measure) {
                case "seconds" -> Objective.Measure.SECONDS;
                case "meters" -> Objective.Measure.METERS;
                case "joules" -> Objective.Measure.JOULES;
                default ->
                    throw InvalidInput.outside(
                            ValueProblem.VALUE_NOT_ALLOWED, at + "measure", MEASURES, "\"" + measure + "\"");
            };
        }
    }
}
