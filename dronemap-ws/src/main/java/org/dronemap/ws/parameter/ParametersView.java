package org.dronemap.ws.parameter;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterComparison;
import org.dronemap.core.parameter.ParameterFileContent;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/**
 * The parameters on board of a vehicle as clients see them.
 *
 * @param readAt when the list was last read whole; null when it never was
 * @param total how many there are, found or not
 */
@Schema(name = "ParametersView")
public record ParametersView(@Nullable Instant readAt, int total, List<ParameterView> parameters) {
    /** {@code type}: int8 to int64, uint8 to uint64, real32 or real64. */
    @Schema(name = "ParameterView")
    public record ParameterView(
            String name, @EnumValues(ParameterType.class) String type, double value) {
        static ParameterView of(Parameter parameter) {
            return new ParameterView(
                    parameter.name(), parameter.type().name().toLowerCase(Locale.ROOT), parameter.value());
        }
    }

    /** A value in a file that is not the vehicle's. */
    @Schema(name = "ParametersDifferenceView")
    public record DifferenceView(
            String name, @EnumValues(ParameterType.class) String type, double held, double wanted) {
        static DifferenceView of(ParameterComparison.Difference difference) {
            ParameterView view = ParameterView.of(difference.held());
            return new DifferenceView(view.name(), view.type(), view.value(), difference.wanted());
        }
    }

    /**
     * A line of a parameter file that is not taken as it stands.
     *
     * @param line from 1
     * @param code as in problems
     * @param why a sentence
     */
    @Schema(name = "ParametersLeftOutView")
    public record LeftOutLineView(int line, String code, String why) {
        static LeftOutLineView of(ParameterFileContent.LeftOut line) {
            return new LeftOutLineView(line.line(), problem(line.reason()).word(), line.why());
        }

        private static ValueProblem problem(ParameterFileContent.Reason reason) {
            return switch (reason) {
                case OTHER_COMPONENT, OTHER_VEHICLE -> ValueProblem.VALUE_NOT_ALLOWED;
                case INSTRUCTION -> ValueProblem.MEMBER_UNKNOWN;
                case MALFORMED -> ValueProblem.VALUE_MALFORMED;
                case REPEATED -> ValueProblem.VALUE_NOT_UNIQUE;
            };
        }
    }

    /**
     * Comparison of a parameter file with a vehicle: the values that loading it would change, or changes.
     *
     * @param unknown names that the vehicle does not have; they are left out
     * @param unfit values that the vehicle cannot hold; they are left out
     * @param leftOut lines of the file that are not taken as they stand
     * @param command the change under way; null for a dry run, or when there is nothing to change
     */
    @Schema(name = "ParametersFileView")
    public record FileView(
            List<DifferenceView> different,
            int same,
            List<String> unknown,
            List<DifferenceView> unfit,

            @Schema(description = "Lines of the file that are not taken as they stand, such as those for a gimbal")
            List<LeftOutLineView> leftOut,

            @Nullable CommandView command) {
        static FileView of(
                ParameterComparison comparison,
                List<ParameterFileContent.LeftOut> leftOut,
                @Nullable CommandView command) {
            return new FileView(
                    comparison.different().stream().map(DifferenceView::of).toList(),
                    comparison.same(),
                    comparison.unknown(),
                    comparison.unfit().stream().map(DifferenceView::of).toList(),
                    leftOut.stream().map(LeftOutLineView::of).toList(),
                    command);
        }
    }
}
