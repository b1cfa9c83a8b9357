package org.dronemap.ws.server;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronemap.store.postgres.DatabaseSettings;
import org.dronemap.store.postgres.PostgresStores;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.settings.ServerSettings;

/** Opens the PostgreSQL database that the settings name, or starts the server's own in the data directory. */
public final class DatabaseBuilder {
    private final ServerSettings settings;

    public DatabaseBuilder(ServerSettings settings) {
        this.settings = settings;
    }

    /** It is handed to {@code closing}. */
    public PostgresStores open(ShutdownSequence closing) {
        Path directory = settings.dataDirectory();
        try {
            Files.createDirectories(directory);
        } catch (IOException e) {
            throw new SetupException(
                    "The data directory " + directory + " (DRONEMAP_DATA_DIR) cannot be made: " + e.getMessage(), e);
        }
        if (!Files.isWritable(directory)) {
            throw new SetupException("The data directory " + directory + " (DRONEMAP_DATA_DIR) cannot be written to.");
        }
        String url = settings.databaseUrl();
        PostgresStores database = url == null
                ? PostgresStores.openOwn(directory.resolve("postgres"))
                : PostgresStores.open(DatabaseSettings.of(url));
        closing.add("the database", database);
        return database;
    }
}
