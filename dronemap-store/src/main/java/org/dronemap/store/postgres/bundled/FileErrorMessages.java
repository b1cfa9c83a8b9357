package org.dronemap.store.postgres.bundled;

import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.util.Objects;
import org.dronemap.store.StoreException;

/** Explains file errors of the bundled PostgreSQL to the server's operator, and says what to do about them. */
final class FileErrorMessages {
    private FileErrorMessages() {}

    static StoreException exception(String what, Exception error) {
        return new StoreException(what + ": " + describe(error), error);
    }

    private static String describe(Exception error) {
        String said = Objects.requireNonNullElse(error.getMessage(), error.toString());
        if (error instanceof AccessDeniedException denied) {
            return "no right to write " + denied.getFile() + "; give the user \"" + System.getProperty("user.name")
                    + "\" that right or name another directory.";
        }
        if (error instanceof FileAlreadyExistsException exists) {
            return exists.getFile() + " is a file, not a directory; name another directory.";
        }
        return advice(error instanceof FileSystemException file ? message(file) : said);
    }

    /** Adds what to do to what the system or PostgreSQL said. */
    static String advice(String said) {
        if (said.contains("No space left on device") || said.contains("Disk quota exceeded")) {
            return "the disk is full; free some space and start again. (" + said + ")";
        }
        if (said.contains("Read-only file system")) {
            return "the file system is read-only; name another directory. (" + said + ")";
        }
        if (said.contains("Permission denied")) {
            return "a right is missing; the directory must belong to the user who starts the server. (" + said + ")";
        }
        return said;
    }

    private static String message(FileSystemException error) {
        return error.getFile() + ": " + Objects.requireNonNullElse(error.getReason(), error.toString());
    }
}
