package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Takes every figure of {@code measured.json} from a replay and holds it against what a real ArduCopter did. */
class MeasuredFiguresTest {
    private static final Path MEASURED = Path.of("exchanges", "recorded", "measured.json");
    private static final double ROUNDING = 0.002;
    private static final Pattern FIGURE =
            Pattern.compile("\"(\\w+)\": \\{\\s*\"value\": ([-\\d.]+),\\s*\"unit\": \"[^\"]*\","
                    + "\\s*\"tolerance\": ([\\d.]+),\\s*\"exchange\": \"(\\w+)\"");

    /** What differs and stays different, with the reason. */
    private static final Map<String, String> DIFFERENT = Map.of(
            "hoverAmperes",
            "the current is the airframe's, not the autopilot's: the simulated one hovers with 14 A for twenty minutes");

    private static final System.Logger LOG = System.getLogger(MeasuredFiguresTest.class.getName());

    private final FigureMeasurements measures = new FigureMeasurements();

    record Figure(String key, double value, double tolerance, RecordedExchange exchange) {
        @Override
        public String toString() {
            return key;
        }
    }

    static Stream<Figure> figures() throws IOException {
        return FIGURE.matcher(Files.readString(MEASURED))
                .results()
                .map(match -> new Figure(
                        match.group(1),
                        Double.parseDouble(match.group(2)),
                        Double.parseDouble(match.group(3)),
                        RecordedExchange.valueOf(match.group(4).toUpperCase(Locale.ROOT))));
    }

    static Stream<Figure> sameFigures() throws IOException {
        return figures().filter(figure -> !DIFFERENT.containsKey(figure.key()));
    }

    static Stream<Figure> differentFigures() throws IOException {
        return figures().filter(figure -> DIFFERENT.containsKey(figure.key()));
    }

    @ParameterizedTest
    @MethodSource("sameFigures")
    void fliesLikeTheRealOne(Figure figure) {
        ToDoubleFunction<Transcript> measure = measures.of(figure.key());
        RecordedScenario scene = new RecordedScenario(figure.exchange());
        assertThat(measure.applyAsDouble(scene.recorded()))
                .as("as recorded")
                .isEqualTo(figure.value(), within(ROUNDING));
        scene.play();
        assertThat(measure.applyAsDouble(scene.played()))
                .as("simulated")
                .isEqualTo(figure.value(), within(figure.tolerance()));
    }

    /** So that the list does not outlive its reasons. */
    @ParameterizedTest
    @MethodSource("differentFigures")
    void differsOnlyInWhatIsListed(Figure figure) {
        RecordedScenario scene = new RecordedScenario(figure.exchange());
        scene.play();
        double simulated = measures.of(figure.key()).applyAsDouble(scene.played());
        LOG.log(
                System.Logger.Level.INFO,
                "{0}: measured {1}, simulated {2}: {3}",
                figure.key(),
                figure.value(),
                simulated,
                DIFFERENT.get(figure.key()));
        assertThat(Math.abs(simulated - figure.value())).isGreaterThan(figure.tolerance());
    }

    @Test
    void everyFigureIsTaken() throws IOException {
        long written = Files.readAllLines(MEASURED).stream()
                .filter(line -> line.contains("\"meaning\""))
                .count();
        assertThat(figures()).hasSize((int) written);
    }
}
