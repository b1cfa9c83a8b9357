package org.dronemap.store.postgres;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.HexFormat;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import javax.sql.DataSource;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.stored.StoredNames;
import org.dronemap.store.StoreException;
import org.postgresql.PGConnection;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Restores a backup into the database: checks it, fills a second schema and swaps it with the present one. */
final class BackupRestore {
    private static final Logger LOG = LoggerFactory.getLogger(BackupRestore.class);

    /** No manifest of ours comes near; a larger one is not read into memory. */
    private static final int MAX_MANIFEST_BYTES = 1_000_000;

    private final DataSource dataSource;
    private final Migration migration;
    private final String schema;
    private final String staging;
    private final String replaced;

    BackupRestore(DataSource dataSource, String schema) {
        this.dataSource = dataSource;
        this.migration = new Migration(dataSource);
        this.schema = schema;
        this.staging = schema + "_restore";
        this.replaced = schema + "_replaced";
    }

    BackupSummary from(Path file) {
        try (ZipFile zip = new ZipFile(file.toFile())) {
            BackupManifest manifest = checked(zip);
            fillBeside(zip, manifest);
            return BackupSummary.of(manifest);
        } catch (NoSuchFileException | FileNotFoundException e) {
            throw new StoreException("There is no backup " + file + " that can be read.", e);
        } catch (ZipException e) {
            throw new StoreException(file + " is not a Dronemap backup, or it is damaged: " + e.getMessage() + ".", e);
        } catch (IOException e) {
            throw new StoreException("The backup " + file + " cannot be read: " + e.getMessage(), e);
        }
    }

    private BackupManifest checked(ZipFile zip) throws IOException {
        BackupManifest manifest;
        try (InputStream stream = open(zip, BackupManifest.ENTRY)) {
            byte[] json = stream.readNBytes(MAX_MANIFEST_BYTES + 1);
            if (json.length > MAX_MANIFEST_BYTES) {
                throw new StoreException("The manifest of this backup is damaged: it is too large.");
            }
            manifest = BackupManifest.read(json);
        }
        if (migration.isNewerThanKnown(schema, manifest.schemaVersion())) {
            throw new StoreException("This backup was made by a newer Dronemap (schema " + manifest.schemaVersion()
                    + "); restore it with that version or a later one. Nothing was changed.");
        }
        for (BackupManifest.Table table : manifest.tables()) {
            if (!table.sha256().equals(checksum(zip, table))) {
                throw new StoreException("This backup is damaged: " + table.entry()
                        + " does not have the checksum that the manifest states. Nothing was changed.");
            }
        }
        return manifest;
    }

    private static String checksum(ZipFile zip, BackupManifest.Table table) throws IOException {
        MessageDigest digest = Sha256.digest();
        try (InputStream stream = new DigestInputStream(open(zip, table.entry()), digest)) {
            stream.transferTo(OutputStream.nullOutputStream());
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    private void fillBeside(ZipFile zip, BackupManifest manifest) throws IOException {
        try {
            execute("DROP SCHEMA IF EXISTS " + staging + " CASCADE");
            migration.to(staging, manifest.schemaVersion());
            fill(zip, manifest);
            migration.toLatest(staging);
            swapSchemas();
        } catch (SQLException e) {
            throw new StoreException(
                    "The backup cannot be restored; nothing was changed. " + SqlErrorMessages.of(e), e);
        } finally {
            dropStaging();
        }
    }

    private void fill(ZipFile zip, BackupManifest manifest) throws SQLException, IOException {
        try (Connection connection = dataSource.getConnection()) {
            connection.setAutoCommit(false);
            empty(connection, manifest);
            for (BackupManifest.Table table : manifest.tables()) {
                try (InputStream csv = open(zip, table.entry())) {
                    long rows = connection
                            .unwrap(PGConnection.class)
                            .getCopyAPI()
                            .copyIn(
                                    "COPY " + staging + "." + table.name() + " (" + String.join(", ", table.columns())
                                            + ") FROM STDIN WITH (FORMAT csv, HEADER true, ENCODING 'UTF8')",
                                    csv);
                    if (rows != table.rows()) {
                        throw new SQLException(
                                table.entry() + " has " + rows + " rows, and the manifest states " + table.rows());
                    }
                }
            }
            connection.commit();
        }
    }

    /** Of the rows that the migrations put in. */
    private void empty(Connection connection, BackupManifest manifest) throws SQLException {
        String tables = manifest.tables().stream()
                .map(table -> staging + "." + table.name())
                .collect(Collectors.joining(", "));
        if (!tables.isEmpty()) {
            try (Statement statement = connection.createStatement()) {
                statement.execute("TRUNCATE " + tables + " CASCADE");
            }
        }
    }

    /** Epochs of control never come back: those given out since the backup count on. */
    private void keepEpochsRising(Statement statement) throws SQLException {
        try (ResultSet known = statement.executeQuery("SELECT to_regclass('" + schema + ".control_epoch')")) {
            known.next();
            if (known.getString(1) == null) {
                return;
            }
        }
        statement.execute("UPDATE " + staging + ".control_epoch SET reserved = greatest(reserved, (SELECT max(reserved)"
                + " FROM " + schema + ".control_epoch))");
    }

    /** What happened since the backup is missing; numbers go on after those that came along. */
    private void insertRestoredGap(Statement statement) throws SQLException {
        String numbers = "pg_get_serial_sequence('" + staging + ".drone_event', 'id')";
        statement.execute("SELECT setval(" + numbers + ", greatest((SELECT max(id) FROM " + staging
                + ".drone_event), (SELECT max(number) FROM " + staging + ".event_gap), 1))");
        statement.execute("INSERT INTO " + staging + ".event_gap (number, cause, from_at, until_at) SELECT nextval("
                + numbers + "), '" + StoredNames.of(EventGap.Cause.RESTORED) + "', (SELECT at FROM " + staging
                + ".drone_event ORDER BY id DESC LIMIT 1), now()");
    }

    private void swapSchemas() throws SQLException {
        try (Connection connection = dataSource.getConnection();
                Statement statement = connection.createStatement()) {
            connection.setAutoCommit(false);
            // Somebody else's long transaction must not hold this one up for ever.
            statement.execute("SET LOCAL lock_timeout = '30s'");
            keepEpochsRising(statement);
            insertRestoredGap(statement);
            statement.execute("ALTER SCHEMA " + schema + " RENAME TO " + replaced);
            statement.execute("ALTER SCHEMA " + staging + " RENAME TO " + schema);
            statement.execute("DROP SCHEMA " + replaced + " CASCADE");
            connection.commit();
        }
    }

    /** After success there is none; after a failure the failure counts, not the remainder, which the next restore drops. */
    private void dropStaging() {
        try {
            execute("DROP SCHEMA IF EXISTS " + staging + " CASCADE");
        } catch (SQLException e) {
            LOG.warn("The schema {} of a failed restore is still there", staging, e);
        }
    }

    private void execute(String sql) throws SQLException {
        try (Connection connection = dataSource.getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    private static InputStream open(ZipFile zip, String name) throws IOException {
        ZipEntry entry = zip.getEntry(name);
        if (entry == null) {
            throw new StoreException("This is not a Dronemap backup, or it is damaged: it lacks " + name + ".");
        }
        return zip.getInputStream(entry);
    }
}
