package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.store.StoreException;

/**
 * Stores operations (mission runs and follows) and their journals in PostgreSQL; a state and its entry in one
 * statement. Thread-safe.
 */
public final class PostgresOperationStore implements OperationStore {
    private final SqlTransactions sql;

    PostgresOperationStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<SavedOperation> underWay() {
        return sql.list(
                "SELECT * FROM operation WHERE ended_at IS NULL ORDER BY began_at, id", PostgresOperationStore::read);
    }

    @Override
    public Optional<SavedOperation> find(OperationId id) {
        return sql.one("SELECT * FROM operation WHERE id = ?", PostgresOperationStore::read, id.value());
    }

    @Override
    public List<SavedOperation> latest(OrganisationId organisation, String kind, int limit) {
        return sql.list("""
                SELECT * FROM operation WHERE organisation IS NOT DISTINCT FROM ? AND kind = ?
                ORDER BY began_at DESC, id LIMIT ?""", PostgresOperationStore::read, OrganisationColumn.stored(organisation), kind, limit);
    }

    @Override
    public void begin(SavedOperation operation, JournalEntry first) {
        sql.update(
                """
                WITH begun AS (
                    INSERT INTO operation (id, kind, owner, account, organisation, name, began_at, ended_at, last_entry, given, state)
                    VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id)
                INSERT INTO operation_journal (operation_id, number, at, input, decision)
                SELECT id, ?, ?, ?, ? FROM begun""",
                operation.id().value(),
                operation.kind(),
                operation.owner(),
                operation.account(),
                OrganisationColumn.stored(operation.organisation()),
                operation.name(),
                operation.beganAt(),
                operation.endedAt(),
                operation.last(),
                given(operation),
                operation.state(),
                first.number(),
                first.at(),
                first.input(),
                first.decision());
    }

    @Override
    public void append(SavedOperation now, JournalEntry entry) {
        int written = sql.update(
                """
                WITH now AS (
                    UPDATE operation SET ended_at = ?, last_entry = ?, given = ?, state = ?
                    WHERE id = ? AND last_entry = ? RETURNING id)
                INSERT INTO operation_journal (operation_id, number, at, input, decision)
                SELECT id, ?, ?, ?, ? FROM now""",
                now.endedAt(),
                now.last(),
                given(now),
                now.state(),
                now.id().value(),
                entry.number() - 1,
                entry.number(),
                entry.at(),
                entry.input(),
                entry.decision());
        if (written == 0) {
            throw new StoreException("The entry " + entry.number() + " does not follow what is kept of " + now.id());
        }
    }

    @Override
    public List<JournalEntry> journal(OperationId id, long from, int limit) {
        return sql.list(
                """
                SELECT number, at, input, decision FROM operation_journal
                WHERE operation_id = ? AND number >= ? ORDER BY number LIMIT ?""",
                row -> new JournalEntry(
                        row.longInteger("number"), row.time("at"), row.text("input"), row.text("decision")),
                id.value(),
                from,
                limit);
    }

    @Override
    public void forget(OperationId id) {
        sql.update("DELETE FROM operation WHERE id = ?", id.value());
    }

    @Override
    public int forgetEndedBefore(Instant time) {
        return sql.update("DELETE FROM operation WHERE ended_at < ?", time);
    }

    private static String[] given(SavedOperation operation) {
        List<String> texts = new ArrayList<>();
        for (SavedOperation.Given one : operation.given()) {
            texts.add(one.drone().value());
            texts.add(one.command().value());
        }
        return texts.toArray(new String[0]);
    }

    private static SavedOperation read(ResultRow row) throws SQLException {
        List<String> texts = row.texts("given");
        List<SavedOperation.Given> given = new ArrayList<>();
        for (int i = 0; i + 1 < texts.size(); i += 2) {
            given.add(new SavedOperation.Given(new DroneId(texts.get(i)), new CommandId(texts.get(i + 1))));
        }
        return new SavedOperation(
                new OperationId(row.text("id")),
                row.text("kind"),
                row.text("owner"),
                row.text("account"),
                OrganisationColumn.read(row),
                row.text("name"),
                row.time("began_at"),
                row.timeOrNull("ended_at"),
                row.longInteger("last_entry"),
                given,
                row.text("state"));
    }
}
