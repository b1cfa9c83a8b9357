package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.mission.SavedMission;
import org.dronemap.store.MissionOrdering;
import org.dronemap.store.postgres.json.MissionItemJson;

/** Stores the mission library in PostgreSQL. Thread-safe. */
public final class PostgresMissionStore implements MissionStore {
    private final SqlTransactions sql;

    PostgresMissionStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<SavedMission> missions() {
        // Sorted here, for the order of names in a database depends on its collation.
        return sql.list("SELECT * FROM saved_mission", PostgresMissionStore::mission).stream()
                .sorted(MissionOrdering.BY_NAME)
                .toList();
    }

    @Override
    public Optional<SavedMission> mission(String id) {
        return sql.one("SELECT * FROM saved_mission WHERE id = ?", PostgresMissionStore::mission, id);
    }

    @Override
    public void save(SavedMission mission) {
        sql.update(
                """
                INSERT INTO saved_mission (id, name, items, changed_by, changed_at, organisation)
                VALUES (?, ?, ?::json, ?, ?, ?)
                ON CONFLICT (id) DO UPDATE SET name = excluded.name, items = excluded.items,
                    changed_by = excluded.changed_by, changed_at = excluded.changed_at""",
                mission.id(),
                mission.name(),
                MissionItemJson.write(mission.mission().items()),
                mission.changedBy(),
                mission.changedAt(),
                OrganisationColumn.stored(mission.organisation()));
    }

    @Override
    public boolean delete(String id) {
        return sql.update("DELETE FROM saved_mission WHERE id = ?", id) > 0;
    }

    private static SavedMission mission(ResultRow row) throws SQLException {
        return new SavedMission(
                row.text("id"),
                row.text("name"),
                new Mission(MissionItemJson.read(row.text("items"))),
                row.text("changed_by"),
                row.time("changed_at"),
                OrganisationColumn.read(row));
    }
}
