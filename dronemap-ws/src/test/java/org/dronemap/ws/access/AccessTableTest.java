package org.dronemap.ws.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dronemap.ws.testserver.GeneratedSection;
import org.junit.jupiter.api.Test;

/** The table of docs/security.md says what the handlers say. {@code -Ddronemap.approve=true} writes it anew. */
class AccessTableTest {
    private static final Path PAGE = Path.of("..", "docs", "security.md");
    private static final String HEAD =
            "| operation | from | about | costs | record |\n| --- | --- | --- | --- | --- |\n";
    private static final List<String> METHODS = List.of("GET", "POST", "PUT", "PATCH", "DELETE");

    private final List<RestOperation> operations = HandlerCatalogue.all().stream()
            .filter(operation -> !path(operation).equals("/error"))
            .sorted(Comparator.comparing(AccessTableTest::path)
                    .thenComparing(operation -> METHODS.indexOf(operation.method())))
            .toList();

    @Test
    void isTheTableOfThePage() throws IOException {
        GeneratedSection.check(PAGE, "the handlers", table());
    }

    @Test
    void hasAllOperations() {
        assertThat(operations).hasSizeGreaterThan(190);
    }

    /** What sends or takes a file costs more than a request. */
    @Test
    void takesFilesAndExportsFromTheirBudget() {
        assertThat(operations)
                .filteredOn(AccessTableTest::isOfFiles)
                .hasSizeGreaterThanOrEqualTo(14)
                .allSatisfy(operation -> assertThat(operation.access().costs())
                        .as(operation.name())
                        .isEqualTo(RequestCost.EXPORT));
    }

    private static boolean isOfFiles(RestOperation operation) {
        return path(operation).matches(".*/(file|logbook|backup|replays|import)");
    }

    private String table() {
        return operations.stream().map(AccessTableTest::row).collect(Collectors.joining("", HEAD, ""));
    }

    private static String row(RestOperation operation) {
        Access access = operation.access();
        return "| `" + operation.name() + "` | " + words(access.from()) + " | " + words(access.about()) + " | "
                + words(access.costs()) + " | " + words(operation.audit()) + " |\n";
    }

    private static String path(RestOperation operation) {
        return operation.pattern().getPatternString();
    }

    private static String words(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
