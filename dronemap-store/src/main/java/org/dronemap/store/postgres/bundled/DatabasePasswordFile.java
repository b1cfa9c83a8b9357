package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.nio.file.Path;
import org.dronemap.store.secret.RandomFile;

/** The random password of the bundled PostgreSQL, in a file that only its owner can read. */
final class DatabasePasswordFile {
    private static final int BYTES = 32;

    private DatabasePasswordFile() {}

    static String readOrCreate(Path file) {
        try {
            return RandomFile.readOrCreate(file, BYTES);
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot keep the database password", e);
        }
    }
}
