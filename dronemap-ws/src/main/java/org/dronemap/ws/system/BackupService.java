package org.dronemap.ws.system;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.ws.access.RoleChecks;

/** Makes backups of all that the server stores, for administrators. Any thread. */
public final class BackupService {
    private final BackupWriter writer;
    private final Path temporaryDirectory;

    /** Writes a whole backup into a file. */
    public interface BackupWriter {
        void write(Path file) throws IOException;
    }

    public BackupService(BackupWriter writer, Path temporaryDirectory) {
        this.writer = writer;
        this.temporaryDirectory = temporaryDirectory;
    }

    /** A file that belongs to the caller from now on; whole before its first byte is handed out. */
    public Path backup(Principal principal) throws IOException {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        Path file = Files.createTempFile(temporaryDirectory, "backup", ".zip");
        try {
            writer.write(file);
            return file;
        } catch (IOException | RuntimeException e) {
            Files.deleteIfExists(file);
            throw e;
        }
    }
}
