package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.stream.Stream;

/**
 * Directories for databases of tests. PostgreSQL is unpacked once for all tests of a test JVM, which takes longer than most of
 * them; each directory has its files as further names of the same bytes.
 */
public final class TestDatabaseDirectories {
    private static final Path UNPACKED = unpacked();

    private TestDatabaseDirectories() {}

    /** The programs of PostgreSQL lie there as if a server had unpacked them. */
    public static void putPrograms(Path home) {
        copy(UNPACKED, home.resolve(UNPACKED.getFileName()), Files::createLink);
    }

    /** All that a server left there that was stopped: the same database with the same password. */
    static void copyStopped(Path from, Path home) {
        putPrograms(home);
        copy(DatabaseCluster.directory(from), DatabaseCluster.directory(home), TestDatabaseDirectories::copyFile);
        copy(from.resolve("password"), home.resolve("password"), TestDatabaseDirectories::copyFile);
    }

    private interface Copying {
        void copy(Path to, Path from) throws IOException;
    }

    private static void copyFile(Path to, Path from) throws IOException {
        Files.copy(from, to, StandardCopyOption.COPY_ATTRIBUTES);
    }

    private static void copy(Path from, Path to, Copying files) {
        try (Stream<Path> all = Files.walk(from)) {
            for (Path path : all.toList()) {
                Path copy = to.resolve(from.relativize(path).toString());
                if (Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
                    files.copy(copy, path);
                } else {
                    Files.copy(path, copy, StandardCopyOption.COPY_ATTRIBUTES, LinkOption.NOFOLLOW_LINKS);
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Path unpacked() {
        try {
            Path parent = Files.createTempDirectory("dronemap-test-programs");
            Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(parent), "delete-test-programs"));
            return PostgresBinaries.unpack(parent).directory();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** With all that is in it. */
    public static void delete(Path directory) {
        try {
            FileTree.delete(directory);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
