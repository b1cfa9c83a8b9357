package org.dronemap.store.postgres;

import javax.sql.DataSource;
import org.dronemap.store.StoreException;
import org.flywaydb.core.Flyway;
import org.flywaydb.core.api.FlywayException;
import org.flywaydb.core.api.MigrationInfo;
import org.flywaydb.core.api.MigrationInfoService;
import org.flywaydb.core.api.MigrationVersion;
import org.flywaydb.core.api.configuration.FluentConfiguration;

/** Migrates the database schema to a version, and leaves alone a schema newer than this program. */
final class Migration {
    static final String HISTORY_TABLE = "schema_history";

    private final DataSource dataSource;

    Migration(DataSource dataSource) {
        this.dataSource = dataSource;
    }

    void toLatest(String schema) {
        migrate(schema, MigrationVersion.LATEST);
    }

    void to(String schema, String version) {
        migrate(schema, MigrationVersion.fromVersion(version));
    }

    /** True when this program has no migration to that version. */
    boolean isNewerThanKnown(String schema, String version) {
        MigrationVersion asked = MigrationVersion.fromVersion(version);
        return newestKnown(flyway(schema, MigrationVersion.LATEST).info()).compareTo(asked) < 0;
    }

    private void migrate(String schema, MigrationVersion target) {
        try {
            Flyway flyway = flyway(schema, target);
            // Asked for once: each time all scripts are read, and the history of the schema.
            MigrationInfoService info = flyway.info();
            MigrationInfo current = info.current();
            MigrationVersion newest = newestKnown(info);
            if (current != null
                    && current.getVersion() != null
                    && current.getVersion().isNewerThan(newest)) {
                throw new StoreException("The database was written by a newer Dronemap (schema "
                        + current.getVersion() + ", this one knows up to " + newest
                        + "); start that version, or restore a backup made by this one.");
            }
            flyway.migrate();
        } catch (FlywayException e) {
            throw new StoreException("The database schema cannot be brought up to date: " + e.getMessage(), e);
        }
    }

    private static MigrationVersion newestKnown(MigrationInfoService info) {
        MigrationVersion newest = MigrationVersion.EMPTY;
        for (MigrationInfo migration : info.all()) {
            MigrationVersion version = migration.getVersion();
            boolean known = !migration.getScript().isBlank()
                    && !migration.getState().name().startsWith("FUTURE");
            if (version != null && known && version.compareTo(newest) > 0) {
                newest = version;
            }
        }
        return newest;
    }

    private Flyway flyway(String schema, MigrationVersion target) {
        FluentConfiguration configuration = Flyway.configure(Migration.class.getClassLoader())
                .dataSource(dataSource)
                .locations("classpath:org/dronemap/store/migration")
                .defaultSchema(schema)
                .createSchemas(true)
                .table(HISTORY_TABLE)
                .target(target);
        return configuration.load();
    }
}
