package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;

/** Stores the log of commands to drones in PostgreSQL. Thread-safe. */
public final class PostgresCommandStore implements CommandStore {
    private final SqlTransactions sql;

    PostgresCommandStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public boolean begin(CommandRecord command) {
        OutcomeColumns outcome = OutcomeColumns.of(command.outcome());
        CommandRecord.Progress progress = command.progress();
        return sql.update(
                        """
                        INSERT INTO command (id, drone_id, asked_by, face, type, summary, asked_at, phase,
                            progress_done, progress_total, outcome, outcome_by, outcome_reason, outcome_code, finished_at,
                            epoch, content)
                        VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)
                        ON CONFLICT (id) DO NOTHING""",
                        command.id().value(),
                        command.drone().value(),
                        command.by(),
                        command.face(),
                        command.type(),
                        command.summary(),
                        command.at(),
                        command.phase(),
                        progress == null ? null : progress.done(),
                        progress == null ? null : progress.total(),
                        outcome.result(),
                        outcome.by(),
                        outcome.reason(),
                        outcome.code(),
                        command.finishedAt(),
                        command.epoch(),
                        command.content())
                == 1;
    }

    @Override
    public void finish(CommandRecord command) {
        OutcomeColumns outcome = OutcomeColumns.of(command.outcome());
        CommandRecord.Progress progress = command.progress();
        int written = sql.update(
                """
                UPDATE command SET phase = ?, progress_done = ?, progress_total = ?,
                    outcome = ?, outcome_by = ?, outcome_reason = ?, outcome_code = ?, finished_at = ?
                WHERE id = ? AND phase <> 'DONE'""",
                command.phase(),
                progress == null ? null : progress.done(),
                progress == null ? null : progress.total(),
                outcome.result(),
                outcome.by(),
                outcome.reason(),
                outcome.code(),
                command.finishedAt(),
                command.id().value());
        if (written == 0) {
            refuseUnlessEndedAlike(command);
        }
    }

    private void refuseUnlessEndedAlike(CommandRecord command) {
        CommandRecord kept = command(command.id())
                .orElseThrow(() -> new StoreException("Command " + command.id() + " was never begun."));
        if (kept.outcome() == null || !kept.outcome().equals(command.outcome())) {
            throw new StoreException("Command " + command.id() + " has ended already: " + kept.outcome());
        }
    }

    @Override
    public Optional<CommandRecord> command(CommandId id) {
        return sql.one("SELECT * FROM command WHERE id = ?", PostgresCommandStore::command, id.value());
    }

    @Override
    public List<CommandRecord> commandsOf(DroneId drone, int limit) {
        return sql.list(
                "SELECT * FROM command WHERE drone_id = ? ORDER BY asked_at DESC, id COLLATE \"C\" DESC LIMIT ?",
                PostgresCommandStore::command,
                drone.value(),
                limit);
    }

    @Override
    public int endUnfinished(Outcome outcome, Instant at) {
        OutcomeColumns row = OutcomeColumns.of(outcome);
        return sql.update("""
                UPDATE command SET phase = 'DONE', outcome = ?, outcome_by = ?, outcome_reason = ?, outcome_code = ?, finished_at = ?
                WHERE phase <> 'DONE'""", row.result(), row.by(), row.reason(), row.code(), at);
    }

    private static CommandRecord command(ResultRow row) throws SQLException {
        return new CommandRecord(
                new CommandId(row.text("id")),
                new DroneId(row.text("drone_id")),
                row.text("asked_by"),
                row.text("face"),
                row.text("type"),
                row.text("summary"),
                row.time("asked_at"),
                row.name("phase", CommandPhase.class),
                progress(row),
                OutcomeColumns.read(row),
                row.timeOrNull("finished_at"),
                row.longOrNull("epoch"),
                row.textOrNull("content"));
    }

    private static CommandRecord.@Nullable Progress progress(ResultRow row) throws SQLException {
        Integer done = row.integerOrNull("progress_done");
        Integer total = row.integerOrNull("progress_total");
        return done == null || total == null ? null : new CommandRecord.Progress(done, total);
    }
}
