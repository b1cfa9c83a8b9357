package org.dronemap.store.postgres;

import java.util.List;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.store.ZoneOrdering;
import org.dronemap.store.postgres.json.ZoneJson;

/** Stores the zones in PostgreSQL. Thread-safe. */
public final class PostgresZoneStore implements ZoneStore {
    private final SqlTransactions sql;

    PostgresZoneStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<Zone> zones() {
        // Sorted here, for the order of names in a database depends on its collation.
        return sql.list("SELECT body FROM zone", row -> ZoneJson.read(row.text("body"))).stream()
                .sorted(ZoneOrdering.BY_NAME)
                .toList();
    }

    @Override
    public void save(List<Zone> zones) {
        // One statement, one transaction: all of them or none.
        sql.update("""
                INSERT INTO zone (id, name, body)
                SELECT one ->> 'id', one ->> 'name', one FROM json_array_elements(?::json) AS one
                ON CONFLICT (id) DO UPDATE SET name = excluded.name, body = excluded.body""", ZoneJson.write(zones));
    }

    @Override
    public boolean delete(String id) {
        return sql.update("DELETE FROM zone WHERE id = ?", id) > 0;
    }
}
