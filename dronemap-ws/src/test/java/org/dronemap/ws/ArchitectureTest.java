package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.tngtech.archunit.ArchConfiguration;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.resolvers.SelectedClassResolverFromClasspath;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.stored.StoredNames;
import org.dronemap.ws.journal.StoredNameViolations;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.dronemap.ws.reading.RecordAlternatives;
import org.dronemap.ws.violation.CaseViolations;
import org.dronemap.ws.violation.DependencyViolations;
import org.dronemap.ws.violation.HandlerViolations;
import org.dronemap.ws.violation.TimeViolations;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.annotation.JsonTypeResolver;

/**
 * All modules obey the rules of the house, and the rules can fail. Whatever flies can be stepped, but for a few classes that
 * are named with their reasons. In one class, as all classes that ship are read for it.
 */
class ArchitectureTest {
    private static final int MOST_EXCEPTIONS = 15;
    /**
     * Of what our classes mention, the JDK and the libraries of links and arithmetic are read too, as rules ask what is a
     * thread. The web framework takes longer than all of these, and no rule asks what its classes are.
     */
    private static final String[] READ_TOO = {
        "java",
        "org.dronemap",
        "org.java_websocket",
        "com.fazecast",
        "org.bouncycastle",
        "org.eclipse",
        "org.locationtech"
    };

    private static final JavaClasses HOUSE = ArchConfiguration.withThreadLocalScope(configuration -> {
        configuration.setClassResolver(SelectedClassResolverFromClasspath.class);
        configuration.setClassResolverArguments(READ_TOO);
        return new ClassFileImporter()
                .withImportOption(new ImportOption.DoNotIncludeTests())
                .importPackages("org.dronemap");
    });
    private static final JavaClasses PLANTED =
            new ClassFileImporter().importClasses(TimeViolations.class.getDeclaredClasses());

    static Stream<ArchRule> rules() {
        return Stream.of(
                ArchitectureRules.CORE_KNOWS_ONLY_THE_JDK,
                ArchitectureRules.CORE_OPENS_NO_SOCKETS,
                ArchitectureRules.CORE_NAMES_NO_PROTOCOL,
                ArchitectureRules.FLOORS_OF_CORE,
                ArchitectureRules.FLOORS_OF_PROXY,
                ArchitectureRules.NO_CYCLES_IN_PROXY,
                ArchitectureRules.NO_CYCLES_AMONG_TYPES_OF_THE_OUTLET,
                RoomRules.ROOMS_SEE_OTHERS_ALONG_ARROWS_ALONE,
                ArchitectureRules.HANDLERS_SAY_WHO_MAY_CALL_THEM,
                ArchitectureRules.EACH_CODE_OF_A_PROBLEM_IS_TOLD,
                ArchitectureRules.EACH_OBJECTION_IS_IN_THE_CATALOGUE,
                ArchitectureRules.ONLY_THE_WIRING_SEES_LINKS_AND_STORES,
                ArchitectureRules.NO_CYCLES,
                ArchitectureRules.ONLY_THE_GATE_COMMANDS,
                ArchitectureRules.MESSAGES_OF_WEBSOCKETS_ARE_BOUNDED,
                ArchitectureRules.PASSWORDS_ARE_COMPARED_IN_ONE_PLACE,
                ArchitectureRules.STORED_TEXT_HAS_NAMES_OF_ITS_OWN,
                ArchitectureRules.CORE_STORES_NO_NAMES_OF_CLASSES,
                ArchitectureRules.CONSTANTS_THAT_STORES_KNOW_HAVE_STORED_NAMES);
    }

    @ParameterizedTest
    @MethodSource("rules")
    void obeysTheRule(ArchRule rule) {
        rule.check(HOUSE);
    }

    @Test
    void looksAtAllModules() {
        assertThat(HOUSE.stream()
                        .map(type -> type.getPackageName().split("[.]")[2])
                        .distinct())
                .contains("core", "mavlink", "proxy", "store", "ws");
    }

    @Test
    void findsAPlantedViolation() {
        JavaClasses planted = new ClassFileImporter().importClasses(DependencyViolations.class);

        assertThat(ArchitectureRules.ONLY_THE_GATE_COMMANDS.evaluate(planted).hasViolation())
                .isTrue();
        assertThat(ArchitectureRules.PASSWORDS_ARE_COMPARED_IN_ONE_PLACE
                        .evaluate(planted)
                        .hasViolation())
                .isTrue();
        assertThat(ArchitectureRules.MESSAGES_OF_WEBSOCKETS_ARE_BOUNDED
                        .evaluate(planted)
                        .hasViolation())
                .isTrue();
        assertThat(ArchitectureRules.ONLY_THE_WIRING_SEES_LINKS_AND_STORES
                        .evaluate(planted)
                        .hasViolation())
                .isTrue();
    }

    @Test
    void findsAHandlerThatDoesNotSayWhoMayCallIt() {
        JavaClasses planted = new ClassFileImporter().importClasses(HandlerViolations.Forgetful.class);

        assertThat(ArchitectureRules.HANDLERS_SAY_WHO_MAY_CALL_THEM
                        .evaluate(planted)
                        .getFailureReport()
                        .getDetails())
                .singleElement()
                .asString()
                .contains("Forgetful.forgotten");
    }

    @ParameterizedTest
    @ValueSource(strings = {"simple", "constant", "read", "component"})
    void findsPlantedNames(String method) {
        JavaClasses planted = new ClassFileImporter().importClasses(StoredNameViolations.class);

        assertThat(ArchitectureRules.STORED_TEXT_HAS_NAMES_OF_ITS_OWN
                        .evaluate(planted)
                        .getFailureReport()
                        .getDetails())
                .anyMatch(line -> line.contains("StoredNameViolations." + method));
    }

    /** Not one of these changes ever, and nothing is stored under a name that is not among them. */
    @Test
    void storesUnderTheNamesThatItAlwaysStoredUnder() throws IOException {
        Path approved = Path.of("src/test/resources/stored-names.txt");

        List<String> now = HOUSE.stream()
                .filter(type -> type.isAnnotatedWith(Stored.class))
                .map(type -> storedNames(type.reflect()))
                .sorted()
                .toList();

        if (Boolean.getBoolean("dronemap.approve")) {
            assertThat(Files.readAllLines(approved))
                    .as("nothing that was stored is called otherwise")
                    .allSatisfy(line -> assertThat(now).anyMatch(one -> one.startsWith(line.replaceFirst(" }$", ""))));
            Files.write(approved, now);
            return;
        }
        assertThat(now)
                .as("what is new here goes into " + approved + " with -Ddronemap.approve=true; what was there stays")
                .containsExactlyElementsOf(Files.readAllLines(approved));
    }

    private static String storedNames(Class<?> type) {
        String as = type.getAnnotation(Stored.class).as();
        String names = String.join(" ", StoredNames.ofParts(type));
        return type.isEnum() ? "one of: " + names : (as + " { " + names).strip() + " }";
    }

    static Stream<Class<?>> planted() {
        return Arrays.stream(TimeViolations.class.getDeclaredClasses())
                .filter(type -> !type.equals(TimeViolations.FromOutside.class));
    }

    static Stream<String> exceptions() {
        return TimeSourceRules.EXCEPTIONS.keySet().stream().sorted();
    }

    @Test
    void whatFliesHasItsTimeFromOutside() {
        TimeSourceRules.WHAT_FLIES_HAS_ITS_TIME_FROM_OUTSIDE.check(HOUSE);
    }

    @Test
    void looksAtAllThatFlies() {
        assertThat(HOUSE.stream().filter(TimeSourceRules::isOfFlight).map(type -> type.getPackageName()))
                .contains(
                        "org.dronemap.core.cloud",
                        "org.dronemap.core.conduct",
                        "org.dronemap.cognitive.allocate",
                        "org.dronemap.proxy.session",
                        "org.dronemap.proxy.roslink",
                        "org.dronemap.proxy.outlet",
                        "org.dronemap.proxy.outlet.uplink",
                        "org.dronemap.proxy.outlet.client",
                        "org.dronemap.proxy.outlet.rights");
        assertThat(TimeSourceRules.OF_WS).allMatch(HOUSE::contain);
    }

    @ParameterizedTest
    @MethodSource("planted")
    void findsWhatIsPlanted(Class<?> planted) {
        assertThat(TimeSourceRules.noneOf(TimeSourceRules.only(TimeViolations.class.getName()))
                        .evaluate(alone(planted))
                        .hasViolation())
                .isTrue();
    }

    @Test
    void letsThroughWhatHasItsTimeFromOutside() {
        TimeSourceRules.noneOf(TimeSourceRules.only(TimeViolations.class.getName()))
                .check(alone(TimeViolations.FromOutside.class));
    }

    private static JavaClasses alone(Class<?> planted) {
        return PLANTED.that(JavaClass.Predicates.equivalentTo(planted));
    }

    @ParameterizedTest
    @MethodSource("exceptions")
    void needsEachException(String name) {
        assertThat(HOUSE.contain(name)).isTrue();
        assertThat(TimeSourceRules.isOfFlight(HOUSE.get(name))).isTrue();
        assertThat(TimeSourceRules.noneOf(TimeSourceRules.only(name))
                        .evaluate(HOUSE)
                        .hasViolation())
                .isTrue();
    }

    @Test
    void hasFewExceptionsAndAReasonForEach() {
        assertThat(TimeSourceRules.EXCEPTIONS).hasSizeLessThanOrEqualTo(MOST_EXCEPTIONS);
        assertThat(TimeSourceRules.EXCEPTIONS.values()).allMatch(reason -> reason.endsWith("."));
    }

    static Stream<Class<?>> families() {
        return ExhaustiveCaseRules.FAMILIES.keySet().stream().sorted(Comparator.comparing(Class::getName));
    }

    @ParameterizedTest
    @MethodSource("families")
    void hasOneKindForEachRecord(Class<?> family) {
        Class<? extends Enum<?>> kind = ExhaustiveCaseRules.FAMILIES.get(family);
        Set<Class<?>> records = ExhaustiveCaseRules.records(family);

        assertThat(records.stream().flatMap(record -> ExhaustiveCaseRules.kinds(HOUSE.get(record), kind).stream()))
                .containsExactlyInAnyOrderElementsOf(
                        Stream.of(kind.getEnumConstants()).map(Enum::name).toList());
    }

    @Test
    void tellsKindsApartWhereNoneIsForgotten() {
        assertThat(ExhaustiveCaseRules.chains(HOUSE)).containsOnlyKeys(ExhaustiveCaseRules.ASKING_FOR_SEVERAL.keySet());
        assertThat(ExhaustiveCaseRules.ASKING_FOR_SEVERAL.values()).allMatch(reason -> reason.endsWith("."));
        assertThat(ExhaustiveCaseRules.chains(new ClassFileImporter().importClasses(CaseViolations.class)))
                .containsOnlyKeys(CaseViolations.class.getName());
    }

    @Test
    void switchesOverKindsWithoutADefault() throws IOException {
        assertThat(ExhaustiveCaseRules.defaults(ExhaustiveCaseRules.sources(all -> true)))
                .containsExactlyElementsOf(ExhaustiveCaseRules.CANNOT_BY_DEFAULT.keySet());
        assertThat(ExhaustiveCaseRules.defaults(Map.of("planted", planted(CaseViolations.class))))
                .hasSize(1);
    }

    /** A form may be a choice itself, or stand for some of them: those count, unless another member tells them apart. */
    private static Stream<Class<?>> forms(Class<?> choice) {
        return Stream.of(choice.getPermittedSubclasses())
                .flatMap(form -> form.isSealed() && member(form, choice).equals(member(choice, choice))
                        ? forms(form)
                        : Stream.of(form));
    }

    private static String member(Class<?> form, Class<?> choice) {
        return Optional.ofNullable(form.getAnnotation(JsonTypeInfo.class))
                .orElseGet(() -> choice.getAnnotation(JsonTypeInfo.class))
                .property();
    }

    /** A form without a name could not be sent, and the usual reader takes arrays for some objects. */
    @Test
    void knowsEachFormOfABodyByNameAndReadsObjectsAlone() {
        List<Class<?>> choices = HOUSE.stream()
                .filter(type -> type.isAnnotatedWith(JsonTypeInfo.class))
                .<Class<?>>map(JavaClass::reflect)
                .toList();

        assertThat(choices).isNotEmpty().allSatisfy(choice -> {
            assertThat(RecordAlternatives.of(choice).orElseThrow().records().values())
                    .containsExactlyInAnyOrderElementsOf(closed(choice));
            assertThat(choice.getAnnotation(JsonTypeResolver.class))
                    .extracting(JsonTypeResolver::value)
                    .isEqualTo(ObjectOnlyTypeResolver.class);
        });
    }

    /** Without the door to those that are declared elsewhere, which are judged when the server starts. */
    private static List<Class<?>> closed(Class<?> choice) {
        return forms(choice)
                .filter(one -> !one.getName().matches("org\\.dronemap\\.ws\\.stream\\.\\w+\\$OfUseCase"))
                .toList();
    }

    /** Only what translates for a family of vehicles knows what their modes are called. */
    @Test
    void namesNoModeOfAnAutopilot() throws IOException {
        assertThat(ExhaustiveCaseRules.literals(
                        ExhaustiveCaseRules.sources(ExhaustiveCaseRules::isAboveTranslators),
                        ExhaustiveCaseRules.MODES))
                .containsExactlyElementsOf(ExhaustiveCaseRules.NAMING_MODES.keySet());
        assertThat(ExhaustiveCaseRules.literals(
                        Map.of("planted", planted(CaseViolations.class)), ExhaustiveCaseRules.MODES))
                .containsExactly("planted: LAND");
    }

    private static String planted(Class<?> type) throws IOException {
        return Files.readString(Path.of("src/test/java", type.getName().replace('.', '/') + ".java"));
    }
}
