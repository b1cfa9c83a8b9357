package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;

/** Converts audit records to rows of PostgreSQL and back. */
final class AuditRows {
    private static final String HEAD = "SELECT sequence, hash FROM audit ORDER BY sequence DESC LIMIT 1";

    private AuditRows() {}

    static AuditHead head(SqlTransactions sql) {
        return sql.one(HEAD, AuditRows::head).orElse(AuditHead.EMPTY);
    }

    static AuditHead head(Connection connection) throws SQLException {
        try (PreparedStatement statement = SqlTransactions.prepare(connection, HEAD);
                ResultSet result = statement.executeQuery()) {
            return result.next() ? head(new ResultRow(result)) : AuditHead.EMPTY;
        }
    }

    private static AuditHead head(ResultRow row) throws SQLException {
        return new AuditHead(row.longInteger("sequence"), row.text("hash"));
    }

    static Optional<AuditRecord> endingOf(Connection connection, @Nullable String command) throws SQLException {
        try (PreparedStatement statement = SqlTransactions.prepare(
                        connection,
                        "SELECT e.* FROM audit r JOIN audit e ON e.ends = r.sequence"
                                + " WHERE r.command_id = ? AND r.ends IS NULL",
                        command);
                ResultSet result = statement.executeQuery()) {
            return result.next() ? Optional.of(record(new ResultRow(result))) : Optional.empty();
        }
    }

    static @Nullable Long sequenceOf(Connection connection, @Nullable String command) throws SQLException {
        try (PreparedStatement statement = SqlTransactions.prepare(
                        connection, "SELECT sequence FROM audit WHERE command_id = ? AND ends IS NULL", command);
                ResultSet result = statement.executeQuery()) {
            return result.next() ? (Long) result.getLong(1) : null;
        }
    }

    static void insert(Connection connection, AuditRecord record) throws SQLException {
        AuditEntry entry = record.entry();
        try (PreparedStatement statement = SqlTransactions.prepare(
                connection,
                """
                INSERT INTO audit (sequence, happened_at, account_name, organisation_id, access_key, face, operation, drone_id, epoch,
                    command_id, parameters, outcome, reason, latency_millis, ends, hash)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)""",
                record.sequence(),
                entry.at(),
                entry.by(),
                entry.organisation(),
                entry.key(),
                entry.face(),
                entry.operation(),
                entry.drone(),
                entry.epoch(),
                entry.command(),
                entry.parameters(),
                entry.outcome(),
                entry.reason(),
                entry.latencyMillis(),
                entry.ends(),
                record.hash())) {
            statement.executeUpdate();
        }
    }

    /** A row that is not as any record is written gets a hash that no record has. */
    static AuditRecord record(ResultRow row) throws SQLException {
        String outcome = row.text("outcome");
        Optional<AuditOutcome> known = Arrays.stream(AuditOutcome.values())
                .filter(one -> StoredNames.of(one).equals(outcome))
                .findFirst();
        AuditEntry entry = new AuditEntry(
                row.time("happened_at"),
                row.textOrNull("account_name"),
                row.textOrNull("organisation_id"),
                row.textOrNull("access_key"),
                row.text("face"),
                row.text("operation"),
                row.textOrNull("drone_id"),
                row.longOrNull("epoch"),
                row.textOrNull("command_id"),
                row.text("parameters"),
                known.orElse(AuditOutcome.UNKNOWN),
                row.textOrNull("reason"),
                row.longOrNull("latency_millis"),
                row.longOrNull("ends"));
        String hash = row.text("hash");
        boolean asWritten = known.isPresent() && isWhole(row, entry);
        return new AuditRecord(row.longInteger("sequence"), entry, asWritten ? hash : "not as written: " + hash);
    }

    /** Nothing was cut or cleaned while it was read. */
    private static boolean isWhole(ResultRow row, AuditEntry entry) throws SQLException {
        Instant at = row.time("happened_at");
        return entry.at().equals(at)
                && Objects.equals(entry.by(), row.textOrNull("account_name"))
                && Objects.equals(entry.organisation(), row.textOrNull("organisation_id"))
                && Objects.equals(entry.key(), row.textOrNull("access_key"))
                && entry.face().equals(row.text("face"))
                && entry.operation().equals(row.text("operation"))
                && Objects.equals(entry.drone(), row.textOrNull("drone_id"))
                && Objects.equals(entry.command(), row.textOrNull("command_id"))
                && entry.parameters().equals(row.text("parameters"))
                && Objects.equals(entry.reason(), row.textOrNull("reason"));
    }
}
