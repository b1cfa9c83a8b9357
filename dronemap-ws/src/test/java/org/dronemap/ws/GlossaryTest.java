package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** The glossary has each term once, and the class that stands for it exists. */
class GlossaryTest {
    @Test
    void namesAClassForEachTerm() throws IOException {
        JavaClasses classes = new ClassFileImporter()
                .withImportOption(new ImportOption.DoNotIncludeTests())
                .importPackages("org.dronemap");
        Set<String> names = classes.stream()
                .filter(type -> !type.isNestedClass())
                .map(type -> "`" + type.getSimpleName() + "`")
                .collect(Collectors.toSet());
        List<String[]> rows = Files.readAllLines(Path.of("../docs/glossary.md")).stream()
                .filter(line -> line.startsWith("| ") && !line.startsWith("| term ") && !line.startsWith("| ---"))
                .map(line -> line.substring(2).split(" \\| | \\|$"))
                .toList();

        assertThat(rows)
                .hasSizeGreaterThan(40)
                .allSatisfy(row -> assertThat(row)
                        .hasSize(3)
                        .satisfies(cells -> assertThat(names).as(cells[0]).contains(cells[2])));
        assertThat(rows.stream().map(row -> row[0])).doesNotHaveDuplicates().isSorted();
    }
}
