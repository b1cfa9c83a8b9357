package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The files that say what callers see. A test compares; with {@code -Ddronemap.approve=true} it writes them instead, so that a
 * wanted change of the wire is a diff to be read. See docs/how-to-add/wire.md.
 */
final class ApprovalFiles {
    private static final Path ROOT = Path.of("src", "test", "resources", "wire");
    private static final String HOW = "If callers shall see this, approve it: docs/how-to-add/wire.md";

    private ApprovalFiles() {}

    /** Whether this run writes the files. */
    static boolean isApproving() {
        return Boolean.getBoolean("dronemap.approve");
    }

    static Path folder(String name) {
        return ROOT.resolve(name);
    }

    /** One file, which must be as it is there. */
    static void check(String name, String actual) {
        Path file = ROOT.resolve(name);
        if (isApproving()) {
            write(file, actual);
            return;
        }
        assertThat(file).as(name + " is not approved yet. " + HOW).exists();
        assertThat(actual).as(name + " is another one now. " + HOW).isEqualTo(read(file));
    }

    /** All files of a folder, by name: none may be missing there, and none too many. */
    static void checkFolder(String folder, Map<String, String> actual) {
        Set<String> known = names(folder);
        if (isApproving()) {
            known.stream()
                    .filter(name -> !actual.containsKey(name))
                    .forEach(name -> delete(ROOT.resolve(folder).resolve(name)));
        } else if (!known.equals(actual.keySet())) {
            fail("In " + folder + " there are " + known + ", and the server has " + actual.keySet() + ". " + HOW);
        }
        new TreeMap<>(actual).forEach((name, text) -> check(folder + "/" + name, text));
    }

    private static Set<String> names(String folder) {
        Path there = ROOT.resolve(folder);
        if (!Files.isDirectory(there)) {
            return Set.of();
        }
        try (Stream<Path> files = Files.list(there)) {
            return files.map(file -> file.getFileName().toString()).collect(Collectors.toSet());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static void write(Path file, String text) {
        try {
            Files.createDirectories(file.getParent());
            Files.writeString(file, text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void delete(Path file) {
        try {
            Files.delete(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
