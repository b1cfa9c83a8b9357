package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Arrays;
import java.util.stream.Stream;
import org.dronemap.ws.planted.PlantedTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever flies can be stepped, but for a few classes that are named with their reasons. */
class TimeRulesTest {
    private static final int MOST_EXCEPTIONS = 15;
    private static final JavaClasses HOUSE = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("org.dronemap");

    static Stream<Class<?>> planted() {
        return Arrays.stream(PlantedTime.class.getDeclaredClasses())
                .filter(type -> !type.equals(PlantedTime.FromOutside.class));
    }

    static Stream<String> exceptions() {
        return TimeRules.EXCEPTIONS.keySet().stream().sorted();
    }

    @Test
    void whatFliesHasItsTimeFromOutside() {
        TimeRules.WHAT_FLIES_HAS_ITS_TIME_FROM_OUTSIDE.check(HOUSE);
    }

    @Test
    void looksAtAllThatFlies() {
        assertThat(HOUSE.stream().filter(TimeRules::isOfFlight).map(type -> type.getPackageName()))
                .contains(
                        "org.dronemap.core.cloud",
                        "org.dronemap.core.conduct",
                        "org.dronemap.cognitive.allocate",
                        "org.dronemap.proxy.session",
                        "org.dronemap.proxy.roslink",
                        "org.dronemap.proxy.outlet");
        assertThat(TimeRules.OF_WS).allMatch(HOUSE::contain);
    }

    @ParameterizedTest
    @MethodSource("planted")
    void findsWhatIsPlanted(Class<?> planted) {
        assertThat(TimeRules.noneOf(TimeRules.only(PlantedTime.class.getName()))
                        .evaluate(new ClassFileImporter().importClasses(planted))
                        .hasViolation())
                .isTrue();
    }

    @Test
    void letsThroughWhatHasItsTimeFromOutside() {
        TimeRules.noneOf(TimeRules.only(PlantedTime.class.getName()))
                .check(new ClassFileImporter().importClasses(PlantedTime.FromOutside.class));
    }

    @ParameterizedTest
    @MethodSource("exceptions")
    void needsEachException(String name) {
        assertThat(HOUSE.contain(name)).isTrue();
        assertThat(TimeRules.isOfFlight(HOUSE.get(name))).isTrue();
        assertThat(TimeRules.noneOf(TimeRules.only(name)).evaluate(HOUSE).hasViolation())
                .isTrue();
    }

    @Test
    void hasFewExceptionsAndAReasonForEach() {
        assertThat(TimeRules.EXCEPTIONS).hasSizeLessThanOrEqualTo(MOST_EXCEPTIONS);
        assertThat(TimeRules.EXCEPTIONS.values()).allMatch(reason -> reason.endsWith("."));
    }
}
