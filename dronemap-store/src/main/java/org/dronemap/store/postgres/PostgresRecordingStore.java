package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingStore;
import org.dronemap.store.RecordingOrdering;

/** Stores descriptions of recordings, not their bytes, in PostgreSQL. Thread-safe. */
public final class PostgresRecordingStore implements RecordingStore {
    private final SqlTransactions sql;

    PostgresRecordingStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<Recording> recordings() {
        // Sorted here, for the order of ids in a database depends on its collation.
        return sql.list("SELECT * FROM recording", PostgresRecordingStore::recording).stream()
                .sorted(RecordingOrdering.NEWEST_FIRST)
                .toList();
    }

    @Override
    public Optional<Recording> recording(String id) {
        return sql.one("SELECT * FROM recording WHERE id = ?", PostgresRecordingStore::recording, id);
    }

    @Override
    public void save(Recording recording) {
        sql.update(
                """
                INSERT INTO recording (id, drone_id, drone_name, started_at, ended_at, bytes, frames, drops, state, notice)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)
                ON CONFLICT (id) DO UPDATE SET drone_id = excluded.drone_id, drone_name = excluded.drone_name,
                    started_at = excluded.started_at, ended_at = excluded.ended_at, bytes = excluded.bytes,
                    frames = excluded.frames, drops = excluded.drops, state = excluded.state,
                    notice = excluded.notice""",
                recording.id(),
                recording.drone().value(),
                recording.droneName(),
                recording.start(),
                recording.end(),
                recording.bytes(),
                recording.frames(),
                recording.drops(),
                recording.state(),
                recording.notice());
    }

    @Override
    public boolean delete(String id) {
        return sql.update("DELETE FROM recording WHERE id = ?", id) > 0;
    }

    private static Recording recording(ResultRow row) throws SQLException {
        return new Recording(
                row.text("id"),
                new DroneId(row.text("drone_id")),
                row.text("drone_name"),
                row.time("started_at"),
                row.timeOrNull("ended_at"),
                row.longInteger("bytes"),
                row.longInteger("frames"),
                row.longInteger("drops"),
                row.name("state", Recording.State.class),
                row.textOrNull("notice"));
    }
}
