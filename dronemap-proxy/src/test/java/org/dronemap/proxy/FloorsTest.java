package org.dronemap.proxy;

import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Which room of the proxy may use which. */
@AnalyzeClasses(packages = "org.dronemap.proxy", importOptions = ImportOption.DoNotIncludeTests.class)
class FloorsTest {
    @ArchTest
    static final ArchRule EACH_ROOM_USES_ONLY_THOSE_BELOW = layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .layer("door")
            .definedBy("org.dronemap.proxy")
            .layer("record")
            .definedBy("..proxy.record")
            .layer("session")
            .definedBy("..proxy.session")
            .layer("translate")
            .definedBy("..proxy.mavlink.translate")
            .layer("procedure")
            .definedBy("..proxy.mavlink.procedure")
            .layer("signing")
            .definedBy("..proxy.signing")
            .layer("endpoint")
            .definedBy("..proxy.endpoint")
            .layer("outlet")
            .definedBy("..proxy.outlet")
            .layer("wire")
            .definedBy("..proxy.roslink.wire")
            .layer("roslink")
            .definedBy("..proxy.roslink")
            .whereLayer("roslink")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("wire")
            .mayOnlyBeAccessedByLayers("roslink")
            .whereLayer("outlet")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("door")
            .mayNotBeAccessedByAnyLayer()
            // The door of robots lies in their own room.
            .whereLayer("record")
            .mayOnlyBeAccessedByLayers("door", "roslink")
            .whereLayer("session")
            .mayOnlyBeAccessedByLayers("door", "record", "outlet", "roslink")
            .whereLayer("translate")
            .mayOnlyBeAccessedByLayers("session", "outlet")
            .whereLayer("procedure")
            .mayOnlyBeAccessedByLayers("session", "translate", "outlet")
            .whereLayer("signing")
            .mayOnlyBeAccessedByLayers("door", "session")
            .whereLayer("endpoint")
            .mayOnlyBeAccessedByLayers("door", "session", "outlet", "roslink");

    @ArchTest
    static final ArchRule THERE_ARE_NO_CYCLES =
            slices().matching("org.dronemap.proxy.(**)").should().beFreeOfCycles();
}
