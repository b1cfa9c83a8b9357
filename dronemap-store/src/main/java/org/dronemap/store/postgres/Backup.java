package org.dronemap.store.postgres;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.sql.DataSource;
import org.postgresql.PGConnection;

/**
 * Writes the database into one zip file, and restores it from one. Sessions are left out: nobody stays signed in over a
 * restore.
 */
public final class Backup {
    private final DataSource dataSource;
    private final String schema;

    Backup(DataSource dataSource, String schema) {
        this.dataSource = dataSource;
        this.schema = schema;
    }

    /**
     * Writes the state of one moment while others go on writing; leaves {@code out} open.
     *
     * @throws IOException when {@code out} does not take it
     */
    public BackupSummary write(OutputStream out) throws IOException {
        try (Connection connection = dataSource.getConnection()) {
            connection.setAutoCommit(false);
            connection.setTransactionIsolation(Connection.TRANSACTION_REPEATABLE_READ);
            connection.setReadOnly(true);
            try {
                return write(connection, out);
            } finally {
                connection.rollback();
            }
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    /**
     * Replaces everything by what the backup holds, or changes nothing at all: the backup is checked first, filled
     * into a schema beside the present one, and the two change places in one transaction. Whoever holds state of the
     * old database in memory has to read it anew.
     */
    public BackupSummary restore(Path zip) {
        return new BackupRestore(dataSource, schema).from(zip);
    }

    private BackupSummary write(Connection connection, OutputStream out) throws SQLException, IOException {
        String version;
        Instant now;
        try (Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery("SELECT now(), (SELECT version FROM " + schema + "."
                        + Migration.HISTORY_TABLE
                        + " WHERE success AND version IS NOT NULL ORDER BY installed_rank DESC LIMIT 1)")) {
            result.next();
            now = result.getObject(1, OffsetDateTime.class).toInstant();
            version = result.getString(2);
        }
        ZipOutputStream zip = new ZipOutputStream(out);
        List<BackupManifest.Table> tables = new ArrayList<>();
        for (Map.Entry<String, List<String>> table :
                new TableCatalog(connection, schema).tablesInOrder().entrySet()) {
            tables.add(write(connection, table.getKey(), table.getValue(), zip));
        }
        BackupManifest manifest = new BackupManifest(version, now, tables);
        zip.putNextEntry(new ZipEntry(BackupManifest.ENTRY));
        zip.write(manifest.json());
        zip.closeEntry();
        zip.finish();
        zip.flush();
        return BackupSummary.of(manifest);
    }

    private BackupManifest.Table write(Connection connection, String table, List<String> columns, ZipOutputStream zip)
            throws SQLException, IOException {
        zip.putNextEntry(new ZipEntry(BackupManifest.Table.entry(table)));
        MessageDigest digest = Sha256.digest();
        long rows = connection
                .unwrap(PGConnection.class)
                .getCopyAPI()
                .copyOut(
                        // As a query, for a table that has parts cannot be copied by its name.
                        "COPY (SELECT " + String.join(", ", columns) + " FROM " + schema + "." + table
                                + ") TO STDOUT WITH (FORMAT csv, HEADER true, ENCODING 'UTF8')",
                        new DigestOutputStream(zip, digest));
        zip.closeEntry();
        return new BackupManifest.Table(table, columns, rows, HexFormat.of().formatHex(digest.digest()));
    }
}
