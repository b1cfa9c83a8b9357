package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What docs/security.md says of threats is shown by tests that exist, and no threat of the table is left out. */
class ThreatsTest {
    private static final Path ROOT = Path.of("..");
    private static final Pattern JAVA = Pattern.compile("`(\\w+)\\.(\\w+)`");
    private static final Pattern PYTHON = Pattern.compile("`(\\w+\\.py)::(\\w+)`");

    @Test
    void namesTestsThatExist() throws IOException {
        List<String> missing = new ArrayList<>();
        int named = 0;
        for (String row : rows()) {
            Matcher java = JAVA.matcher(shownBy(row));
            while (java.find()) {
                named++;
                if (!contains(java.group(1) + ".java", "void " + java.group(2) + "(")) {
                    missing.add(java.group());
                }
            }
            Matcher python = PYTHON.matcher(shownBy(row));
            while (python.find()) {
                named++;
                if (!contains(python.group(1), "def " + python.group(2) + "(")) {
                    missing.add(python.group());
                }
            }
        }

        assertThat(missing).isEmpty();
        assertThat(named).isGreaterThan(30);
    }

    @Test
    void leavesNoThreatWithoutATestThatShowsWhatIsDone() throws IOException {
        assertThat(rows())
                .hasSizeGreaterThanOrEqualTo(15)
                .allSatisfy(row -> assertThat(JAVA.matcher(shownBy(row)).find()
                                || PYTHON.matcher(shownBy(row)).find())
                        .as(row)
                        .isTrue());
    }

    private static String shownBy(String row) {
        return row.substring(row.lastIndexOf('|', row.length() - 2));
    }

    private static List<String> rows() throws IOException {
        List<String> lines = Files.readAllLines(ROOT.resolve("docs/security.md"));
        int from = lines.indexOf("## Threats and what is done");
        assertThat(from).isPositive();
        return lines.subList(from, lines.size()).stream()
                .filter(line -> line.startsWith("| ") && !line.startsWith("| threat") && !line.startsWith("| ---"))
                .toList();
    }

    private static boolean contains(String file, String text) throws IOException {
        try (Stream<Path> all = sources()) {
            return all.filter(path -> path.getFileName().toString().equals(file))
                    .anyMatch(path -> {
                        try {
                            return Files.readString(path).contains(text);
                        } catch (IOException e) {
                            throw new UncheckedIOException(e);
                        }
                    });
        }
    }

    private static Stream<Path> sources() throws IOException {
        List<Path> found = new ArrayList<>();
        try (Stream<Path> modules = Files.list(ROOT)) {
            for (Path module : modules.toList()) {
                for (Path tests : List.of(module.resolve("src/test/java"), module.resolve("tests"))) {
                    if (Files.isDirectory(tests)) {
                        try (Stream<Path> inside = Files.walk(tests)) {
                            inside.filter(Files::isRegularFile).forEach(found::add);
                        }
                    }
                }
            }
        }
        return found.stream();
    }
}
