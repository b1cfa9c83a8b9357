package org.dronemap.ws.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.Objects;
import java.util.stream.Stream;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.Objective.Measure;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.JsonCodec;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class PlanObjectiveRequestTest {
    private static final String KINDS = "earliestEnd, leastTime, leastDistance, leastEnergy or weighted";
    private static final String WEIGHTS = "\"kind\":\"weighted\",\"longestWeight\":2,\"sumWeight\":3";

    private static Objective read(String members) {
        PlanRequest request = new JsonCodec().read("{\"objective\":{" + members + "}}", PlanRequest.class);
        return Objects.requireNonNull(request.objective()).read("objective.");
    }

    static Stream<Arguments> kinds() {
        return Stream.of(
                Arguments.of("\"kind\":\"earliestEnd\"", Objective.earliestEnd()),
                Arguments.of("\"kind\":\"leastTime\",\"everyDrone\":true", new Objective(0, Measure.SECONDS, 1, true)),
                Arguments.of(
                        "\"kind\":\"leastDistance\",\"everyDrone\":null", new Objective(0, Measure.METERS, 1, false)),
                Arguments.of("\"kind\":\"leastEnergy\"", new Objective(0, Measure.JOULES, 1, false)),
                Arguments.of(WEIGHTS, new Objective(2, Measure.SECONDS, 3, false)),
                Arguments.of(
                        WEIGHTS + ",\"measure\":\"meters\",\"everyDrone\":true",
                        new Objective(2, Measure.METERS, 3, true)));
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void isReadByItsKind(String members, Objective meant) {
        assertThat(read(members)).isEqualTo(meant);
    }

    static Stream<Arguments> faults() {
        return Stream.of(
                Arguments.of(
                        "\"kind\":\"leastTime\",\"sumWeight\":1",
                        "There is no member \"objective.sumWeight\" here; there are: kind, everyDrone."),
                Arguments.of(
                        WEIGHTS + ",\"best\":1",
                        "There is no member \"objective.best\" here; there are: kind, longestWeight, sumWeight, measure,"
                                + " everyDrone."),
                Arguments.of("\"everyDrone\":true", "\"objective.kind\" is missing; it must be " + KINDS + "."),
                Arguments.of("\"kind\":\"best\"", "\"objective.kind\" must be " + KINDS + ", not \"best\"."),
                Arguments.of(
                        "\"kind\":\"weighted\",\"longestWeight\":0,\"sumWeight\":0",
                        "\"objective.sumWeight\" must be above 0 where longestWeight is 0, not 0.0."),
                Arguments.of(
                        WEIGHTS + ",\"measure\":\"miles\"",
                        "\"objective.measure\" must be seconds, meters or joules, not \"miles\"."));
    }

    @ParameterizedTest
    @MethodSource("faults")
    void isRefusedInASentence(String members, String sentence) {
        Rejection refused = catchThrowableOfType(Rejection.class, () -> read(members));

        assertThat(refused.sentence()).isEqualTo(sentence);
    }
}
