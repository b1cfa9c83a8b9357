package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.stream.Stream;
import org.dronemap.ws.planted.PlantedViolation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** All modules obey the rules of the house, and the rules can fail. */
class HouseTest {
    private static final JavaClasses HOUSE = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("org.dronemap");

    static Stream<ArchRule> rules() {
        return Stream.of(
                HouseRules.CORE_KNOWS_ONLY_THE_JDK,
                HouseRules.CORE_OPENS_NO_SOCKETS,
                HouseRules.CORE_NAMES_NO_PROTOCOL,
                HouseRules.FLOORS_OF_CORE,
                HouseRules.FLOORS_OF_WS,
                HouseRules.ONLY_THE_WIRING_SEES_LINKS_AND_STORES,
                HouseRules.NO_CYCLES,
                HouseRules.ONLY_THE_GATE_COMMANDS);
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
        JavaClasses planted = new ClassFileImporter().importClasses(PlantedViolation.class);

        assertThat(HouseRules.ONLY_THE_GATE_COMMANDS.evaluate(planted).hasViolation())
                .isTrue();
        assertThat(HouseRules.ONLY_THE_WIRING_SEES_LINKS_AND_STORES
                        .evaluate(planted)
                        .hasViolation())
                .isTrue();
    }
}
