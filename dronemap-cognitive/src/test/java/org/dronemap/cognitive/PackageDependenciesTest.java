package org.dronemap.cognitive;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Each room of planning uses only those below it, and nothing but core beside them. */
class PackageDependenciesTest {
    private static final String ROOM = "org.dronemap.cognitive.";
    private static final JavaClasses PLANNING = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("org.dronemap.cognitive");

    private static final ArchRule FLOORS = layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .withOptionalLayers(true)
            .layer("problem")
            .definedBy(ROOM + "problem..")
            .layer("plan")
            .definedBy(ROOM + "plan..")
            .layer("cost")
            .definedBy(ROOM + "cost..")
            .layer("allocate")
            .definedBy(ROOM + "allocate..")
            .layer("replan")
            .definedBy(ROOM + "replan..")
            .layer("engine")
            .definedBy(ROOM + "engine..")
            .layer("operation")
            .definedBy(ROOM + "operation..")
            .whereLayer("operation")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("engine")
            .mayOnlyBeAccessedByLayers("operation")
            .whereLayer("replan")
            .mayOnlyBeAccessedByLayers("engine", "operation")
            .whereLayer("allocate")
            .mayOnlyBeAccessedByLayers("replan", "engine", "operation")
            .whereLayer("cost")
            .mayOnlyBeAccessedByLayers("allocate", "replan", "engine", "operation")
            .whereLayer("plan")
            .mayOnlyBeAccessedByLayers("cost", "allocate", "replan", "engine", "operation");

    private static final ArchRule CORE_ONLY = classes()
            .that()
            .resideInAPackage("org.dronemap.cognitive..")
            .should()
            .onlyDependOnClassesThat()
            .resideInAnyPackage(
                    "org.dronemap.cognitive..", "org.dronemap.core..", "java..", "org.jspecify..", "org.slf4j..");

    private static final ArchRule FOLLOWING_LEANS_ON_GEOMETRY = classes()
            .that()
            .resideInAPackage(ROOM + "follow..")
            .should()
            .onlyDependOnClassesThat()
            .resideInAnyPackage(
                    ROOM + "follow..",
                    "org.dronemap.core.geo..",
                    "org.dronemap.core.separation..",
                    "org.dronemap.core.stored..",
                    "java..",
                    "org.jspecify..");

    @Test
    void usesOnlyTheRoomsBelow() {
        FLOORS.check(PLANNING);
        FOLLOWING_LEANS_ON_GEOMETRY.check(PLANNING);
        CORE_ONLY.check(PLANNING);
    }

    @Test
    void looksAtTheRoomsThatStand() {
        List<String> rooms = PLANNING.stream()
                .map(type -> type.getPackageName().replace(ROOM, ""))
                .distinct()
                .toList();
        assertThat(rooms).contains("problem", "plan", "cost", "follow", "operation.run");
    }
}
