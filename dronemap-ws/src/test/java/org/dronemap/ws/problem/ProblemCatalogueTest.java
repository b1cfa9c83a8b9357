package org.dronemap.ws.problem;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.virtual.UnfitCode;
import org.junit.jupiter.api.Test;

/** The catalogue of problems, and docs/problems.md, which {@code -Ddronemap.approve=true} writes anew from it. */
class ProblemCatalogueTest {
    private static final Path PAGE = Path.of("..", "docs", "problems.md");
    private static final String BEGIN = "<!-- written from the catalogue: begin -->\n";
    private static final String END = "<!-- written from the catalogue: end -->\n";
    /** Told by a sentence that another code has, too, as people do not need to know which. */
    private static final Set<String> SAME_SENTENCES =
            Set.of("not-written-down", "plan-without-result", "follow-has-drone");

    private static final int WORDS_IN_A_ROW = 3;
    private static final String OUTCOMES = "Commands";
    private static final String OF_OUTCOMES =
            "These are also the `code` of the outcome of a command, in each face: a refusal"
                    + " by the cloud is told at once as a problem\nover REST and on the stream, and as an outcome over SOAP; what"
                    + " comes later, such as a refusal by the vehicle, is told as\nan outcome alone.\n\n";

    private static final String UNFIT = "Drones that cannot serve";
    private static final String OF_UNFIT = "These are the `code` beside a drone that cannot serve a virtual one. No"
            + " request is refused for them. Other codes stand\nthere, too: of commands, for what the gate would refuse,"
            + " and `contact-not-good`, `link-falling`, `drone-not-at-rest`,\n`position-unknown` and `battery-unknown`.\n\n";
    private static final Map<String, String> INTRODUCTIONS = Map.of(OUTCOMES, OF_OUTCOMES, UNFIT, OF_UNFIT);

    @Test
    void isWhatThePageSays() throws IOException {
        String page = Files.readString(PAGE);
        int begin = page.indexOf(BEGIN) + BEGIN.length();
        int end = page.indexOf(END);
        assertThat(begin).isBetween(BEGIN.length(), end);
        if (Boolean.getBoolean("dronemap.approve")) {
            Files.writeString(PAGE, page.substring(0, begin) + tables() + page.substring(end));
            return;
        }
        assertThat(page.substring(begin, end))
                .as("approve what was meant to change with -Ddronemap.approve=true")
                .isEqualTo(tables());
    }

    @Test
    void hasEachCodeAndEachMeaningOnce() {
        assertThat(ProblemCode.all()).hasSizeGreaterThan(100);
        assertThat(ProblemCode.all()).extracting(ProblemCode::word).doesNotHaveDuplicates();
        assertThat(ProblemCode.all())
                .extracting(code -> code.entry().meaning().toLowerCase(Locale.ROOT))
                .doesNotHaveDuplicates();
        assertThat(ProblemCode.all().stream().filter(code -> !SAME_SENTENCES.contains(code.word())))
                .extracting(code -> code.entry().example())
                .doesNotHaveDuplicates();
        assertThat(ProblemParameter.values()).extracting(ProblemParameter::word).doesNotHaveDuplicates();
    }

    @Test
    void hasEachReasonWhyADroneCannotServe() {
        assertThat(ProblemCode.all())
                .extracting(ProblemCode::word)
                .containsAll(
                        Arrays.stream(UnfitCode.values()).map(UnfitCode::word).toList());
    }

    @Test
    void speaksInWordsAndWholeSentences() {
        assertThat(ProblemCode.all()).allSatisfy(code -> {
            assertThat(code.word()).matches("[a-z]+(-[a-z]+)+");
            assertThat(code.entry().meaning()).as(code.word()).endsWith(".");
            assertThat(code.entry().example()).as(code.word()).endsWith(".");
        });
    }

    @Test
    void leavesNoParameterWithoutACode() {
        List<ProblemParameter> told = ProblemCode.all().stream()
                .flatMap(code -> Stream.concat(code.entry().parameters().stream(), code.entry().optional().stream()))
                .distinct()
                .toList();

        assertThat(told).containsExactlyInAnyOrder(ProblemParameter.values());
    }

    /** An example that nobody says any more misleads. */
    @Test
    void givesExamplesOfWhatIsSaid() throws IOException {
        String said = literals();

        assertThat(ProblemCode.all())
                .allSatisfy(code -> assertThat(partsOf(code.entry().example()))
                        .as(code.word())
                        .anyMatch(said::contains));
    }

    private static List<String> partsOf(String sentence) {
        List<String> words = Arrays.asList(sentence.replaceAll("[.]$", "").split(" "));
        int length = Math.min(WORDS_IN_A_ROW, words.size());
        return IntStream.rangeClosed(0, words.size() - length)
                .mapToObj(from -> String.join(" ", words.subList(from, from + length)))
                .toList();
    }

    /** All that our programs say, but for the catalogue. */
    private static String literals() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of(".."), 12)) {
            return files.filter(file ->
                            file.toString().matches(".*/src/main/java/.*(?<!Problem|/OutcomeCode|/UnfitCode)\\.java"))
                    .map(ProblemCatalogueTest::text)
                    .map(text -> text.replaceAll("\"\\s*\\+\\s*\"", ""))
                    .collect(Collectors.joining("\n"));
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void refusesParametersThatAreNotDeclared() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Rejection.of(
                        DroneProblem.LOG_FETCHED,
                        "It flies.",
                        ProblemParameter.DRONE.is("d1"),
                        ProblemParameter.MOST.is(1)))
                .withMessageContaining("log-fetched");
    }

    @Test
    void refusesToLeaveOutParametersThatAreDeclared() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Rejection.of(DroneProblem.LOG_FETCHED, "It flies."))
                .withMessageContaining("DRONE");
    }

    @Test
    void refusesTheSameParameterTwice() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Rejection.of(
                        DroneProblem.LOG_FETCHED,
                        "It flies.",
                        ProblemParameter.DRONE.is("d1"),
                        ProblemParameter.DRONE.is("d2")));
    }

    @Test
    void refusesValuesOfAnotherType() {
        assertThatThrownBy(() -> ProblemParameter.DRONE.is(7)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> ProblemParameter.MOST.is("7")).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void tellsCodeAndParametersInTheProblem() {
        ProblemView problem = ProblemView.of(InvalidInput.outside(
                ValueProblem.VALUE_OUT_OF_RANGE,
                "rate",
                "1 to 10",
                11,
                ProblemParameter.LEAST.is(1),
                ProblemParameter.MOST.is(10)));

        assertThat(problem.code()).isEqualTo("value-out-of-range");
        assertThat(problem.parameters())
                .isEqualTo(Map.of("field", "rate", "allowed", "1 to 10", "least", 1L, "most", 10L));
        assertThat(problem.detail()).isEqualTo("\"rate\" must be 1 to 10, not 11.");
    }

    private static String tables() {
        return subjects().entrySet().stream()
                        .map(subject -> "## " + subject.getKey() + "\n\n"
                                + INTRODUCTIONS.getOrDefault(subject.getKey(), "")
                                + "| code | status | parameters | meaning, and an example |\n| --- | --- | --- | --- |\n"
                                + subject.getValue().stream()
                                        .map(ProblemCatalogueTest::row)
                                        .collect(Collectors.joining()))
                        .collect(Collectors.joining("\n"))
                + "\n## Parameters\n\n| parameter | type | what it tells |\n| --- | --- | --- |\n"
                + Arrays.stream(ProblemParameter.values())
                        .map(parameter -> "| `" + parameter.word() + "` | "
                                + parameter.type().word() + " | " + parameter.meaning() + " |\n")
                        .collect(Collectors.joining());
    }

    private static Map<String, List<? extends ProblemCode>> subjects() {
        Map<String, List<? extends ProblemCode>> subjects = new LinkedHashMap<>();
        subjects.put("Requests as such", List.of(RequestProblem.values()));
        subjects.put("Values", List.of(ValueProblem.values()));
        subjects.put("What there is none of", List.of(NotFoundProblem.values()));
        subjects.put("Accounts and rights", List.of(AccessProblem.values()));
        subjects.put(OUTCOMES, CommandProblem.values());
        subjects.put("Control of drones", List.of(ControlProblem.values()));
        subjects.put("Drones", List.of(DroneProblem.values()));
        subjects.put("Signed links", List.of(LinkSecurityProblem.values()));
        subjects.put("Plans", List.of(OperationProblem.values()));
        subjects.put("Mission runs, follows and virtual drones", ObjectionProblem.values());
        subjects.put(UNFIT, UnfitProblem.values());
        subjects.put("The server", List.of(ServerProblem.values()));
        assertThat(subjects.values().stream().<ProblemCode>flatMap(List::stream))
                .containsExactlyElementsOf(ProblemCode.all());
        return subjects;
    }

    private static String row(ProblemCode code) {
        ProblemCatalogueEntry entry = code.entry();
        boolean isProblem = !(code instanceof UnfitProblem)
                && (!(code instanceof CommandProblem told) || told.outcome().isOfTheGate());
        return "| `" + code.word() + "` | "
                + (isProblem
                        ? code.kind().status() + " " + code.kind().code()
                        : code instanceof UnfitProblem ? "beside a drone" : "outcome")
                + " | "
                + (isProblem ? parameters(entry) : "") + " | " + entry.meaning() + " *"
                + entry.example().replace("|", "\\|") + "* |\n";
    }

    private static String parameters(ProblemCatalogueEntry entry) {
        return Stream.concat(
                        entry.parameters().stream().map(one -> "`" + one.word() + "`"),
                        entry.optional().stream().map(one -> "`" + one.word() + "`?"))
                .collect(Collectors.joining(", "));
    }
}
