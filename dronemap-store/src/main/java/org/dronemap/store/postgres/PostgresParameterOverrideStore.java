package org.dronemap.store.postgres;

import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.store.postgres.json.ParameterOverridesJson;

/**
 * Stores in PostgreSQL the owners' parameter values that the cloud overrides on their drones, to restore them later.
 * Thread-safe.
 */
public final class PostgresParameterOverrideStore implements ParameterOverrideStore {
    private final SqlTransactions sql;

    PostgresParameterOverrideStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<ParameterOverrides> all() {
        return sql.list(
                "SELECT * FROM owners_values ORDER BY drone_id COLLATE \"C\"",
                row -> new ParameterOverrides(
                        new DroneId(row.text("drone_id")),
                        row.text("drone_name"),
                        row.time("since"),
                        row.number("return_meters"),
                        row.bool("written"),
                        ParameterOverridesJson.read(row.text("body"))));
    }

    @Override
    public void save(ParameterOverrides values) {
        sql.update(
                """
                INSERT INTO owners_values (drone_id, drone_name, since, return_meters, written, body)
                VALUES (?, ?, ?, ?, ?, ?::json)
                ON CONFLICT (drone_id) DO UPDATE SET drone_name = excluded.drone_name, since = excluded.since,
                    return_meters = excluded.return_meters, written = excluded.written, body = excluded.body""",
                values.drone().value(),
                values.droneName(),
                values.since(),
                values.returnMeters(),
                values.written(),
                ParameterOverridesJson.write(values.values()));
    }

    @Override
    public void delete(DroneId drone) {
        sql.update("DELETE FROM owners_values WHERE drone_id = ?", drone.value());
    }
}
