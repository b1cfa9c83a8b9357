package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.springframework.context.annotation.Configuration;
import org.springframework.web.bind.annotation.RestController;

/** Rooms are small, say what they are, and the arrows between them are those that are needed. */
class RoomsTest {
    private static final long MOST_FILES = 25;

    @Test
    void needsEachArrow() {
        JavaClasses house = new ClassFileImporter()
                .withImportOption(new ImportOption.DoNotIncludeTests())
                .importPackages("org.dronemap.ws");
        Map<String, Set<String>> used = new TreeMap<>();
        house.forEach(type -> RoomRules.room(type)
                .ifPresent(
                        room -> used.computeIfAbsent(room, r -> new TreeSet<>()).addAll(RoomRules.seen(type))));

        assertThat(used.keySet()).containsAll(RoomRules.FLOORS);
        assertThat(RoomRules.ARROWS)
                .allSatisfy(
                        (room, others) -> assertThat(used.get(room)).as(room).containsAll(others));
    }

    @Test
    void keepsHandlersAndConfigurationsToItself() {
        JavaClasses all = new ClassFileImporter().importPackages("org.dronemap.ws");
        List<JavaClass> own = all.stream()
                .filter(type -> type.isAnnotatedWith(RestController.class) || type.isAnnotatedWith(Configuration.class))
                .filter(type -> !type.getPackageName().matches("org\\.dronemap\\.ws\\.(http|violation)"))
                .toList();

        assertThat(own)
                .hasSizeGreaterThan(50)
                .noneMatch(type -> type.getModifiers().contains(JavaModifier.PUBLIC));
    }

    /** Those of tests would be found by any server that a test starts. */
    @Test
    void hasNoConfigurationsInTests() {
        JavaClasses tests = new ClassFileImporter()
                .withImportOption(new ImportOption.OnlyIncludeTests())
                .importPackages("org.dronemap.ws");

        assertThat(tests).isNotEmpty().noneMatch(type -> type.isAnnotatedWith(Configuration.class));
    }

    @Test
    void hasFewFilesInEachRoomAndSaysWhatEntersIt() throws IOException {
        Path sources = Path.of("src/main/java/org/dronemap/ws");
        Map<Path, Long> files;
        try (Stream<Path> all = Files.walk(sources)) {
            files = all.filter(path -> path.toString().endsWith(".java"))
                    .collect(Collectors.groupingBy(Path::getParent, TreeMap::new, Collectors.counting()));
        }
        assertThat(files.size()).isGreaterThan(40);
        assertThat(files).allSatisfy((room, count) -> {
            assertThat(count).as(room.toString()).isLessThanOrEqualTo(MOST_FILES);
            assertThat(room.resolve("package-info.java")).content().contains("<p>Enters: ", "<p>Never: ");
        });
    }
}
