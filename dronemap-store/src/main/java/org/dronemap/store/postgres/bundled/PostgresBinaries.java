package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Locale;
import org.apache.commons.compress.archivers.tar.TarArchiveEntry;
import org.apache.commons.compress.archivers.tar.TarArchiveInputStream;
import org.dronemap.store.StoreException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.tukaani.xz.XZInputStream;

/** The bundled PostgreSQL's programs, unpacked once from Dronemap's jars into a directory named by their checksum. */
record PostgresBinaries(Path directory) {
    private static final Logger LOG = LoggerFactory.getLogger(PostgresBinaries.class);

    /** Unpacked programs and a fresh cluster take about 130 MB; the rest is room for the write-ahead log. */
    private static final long NEEDED_BYTES = 300L * 1024 * 1024;

    Path program(String name) {
        return directory.resolve("bin").resolve(name);
    }

    /** Finds or makes the unpacked programs under {@code parent}. */
    static PostgresBinaries unpack(Path parent) {
        String archive = archiveName(System.getProperty("os.name"), System.getProperty("os.arch"));
        try {
            Path directory = parent.resolve("postgres-" + checksum(archive).substring(0, 12));
            if (Files.notExists(directory)) {
                requireSpace(parent);
                LOG.info("Unpacking PostgreSQL into {}", directory);
                Path fresh = parent.resolve(directory.getFileName() + ".new");
                FileTree.delete(fresh);
                unpack(archive, fresh);
                Files.move(fresh, directory, StandardCopyOption.ATOMIC_MOVE);
            }
            return new PostgresBinaries(directory);
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot unpack PostgreSQL into " + parent, e);
        }
    }

    static void requireSpace(Path directory) {
        // Not Files.getFileStore: in a chroot it finds no mount point.
        long free = directory.toFile().getUsableSpace();
        if (free < NEEDED_BYTES) {
            throw new StoreException("The disk that holds " + directory + " is full: the database needs "
                    + NEEDED_BYTES / 1_048_576 + " MB to start with and " + free / 1_048_576
                    + " MB are free; free some space or name another directory.");
        }
    }

    /** The archive of this machine, or a sentence when there is none for it. */
    static String archiveName(String system, String processor) {
        boolean linux = system.toLowerCase(Locale.ROOT).equals("linux");
        String name = switch (processor) {
            case "amd64", "x86_64" -> "postgres-linux-x86_64.txz";
            case "aarch64", "arm64" -> "postgres-linux-arm_64.txz";
            default -> "";
        };
        if (!linux || name.isEmpty()) {
            throw new StoreException("Dronemap brings its own PostgreSQL only for Linux on x86-64 and ARM-64, not for "
                    + system + " on " + processor + "; give it one with DRONEMAP_DATABASE_URL.");
        }
        return name;
    }

    private static InputStream open(String archive) throws IOException {
        InputStream stream = PostgresBinaries.class.getResourceAsStream("/" + archive);
        if (stream == null) {
            throw new StoreException("This build lacks PostgreSQL's programs (" + archive
                    + "); give it a database with DRONEMAP_DATABASE_URL.");
        }
        return stream;
    }

    private static String checksum(String archive) throws IOException {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            try (InputStream stream = new DigestInputStream(open(archive), digest)) {
                stream.transferTo(java.io.OutputStream.nullOutputStream());
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    private static void unpack(String archive, Path into) throws IOException {
        Files.createDirectories(into);
        try (TarArchiveInputStream tar = new TarArchiveInputStream(new XZInputStream(open(archive)))) {
            for (TarArchiveEntry entry = tar.getNextEntry(); entry != null; entry = tar.getNextEntry()) {
                unpack(tar, entry, into.resolve(entry.getName()).normalize());
            }
        }
        // Programs are read by whichever account runs them, whatever the umask of the server.
        Files.setPosixFilePermissions(into, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private static void unpack(TarArchiveInputStream tar, TarArchiveEntry entry, Path to) throws IOException {
        if (entry.isDirectory()) {
            Files.createDirectories(to);
            Files.setPosixFilePermissions(to, PosixFilePermissions.fromString("rwxr-xr-x"));
            return;
        }
        Files.createDirectories(to.getParent());
        if (entry.isSymbolicLink()) {
            Files.createSymbolicLink(to, Path.of(entry.getLinkName()));
        } else if (entry.isFile()) {
            Files.copy(tar, to);
            boolean runs = (entry.getMode() & 0100) != 0;
            Files.setPosixFilePermissions(to, PosixFilePermissions.fromString(runs ? "rwxr-xr-x" : "rw-r--r--"));
        }
    }
}
