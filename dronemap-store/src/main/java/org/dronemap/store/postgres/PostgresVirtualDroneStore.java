package org.dronemap.store.postgres;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.store.postgres.json.VirtualDroneJson;

/** Stores virtual drones, and which drones of the warehouse may serve them, in PostgreSQL. Thread-safe. */
public final class PostgresVirtualDroneStore implements VirtualDroneStore {
    /** In no id. */
    private static final String BETWEEN = ",";

    private final SqlTransactions sql;

    PostgresVirtualDroneStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<VirtualDrone> virtualDrones() {
        return sql.list(
                "SELECT body FROM virtual_drone ORDER BY created_at, id COLLATE \"C\"",
                row -> VirtualDroneJson.read(row.text("body")));
    }

    @Override
    public void save(VirtualDrone drone) {
        String bound = drone.bound().stream().map(DroneId::value).collect(Collectors.joining(BETWEEN));
        sql.update(
                """
                WITH bound AS (SELECT unnest(string_to_array(?, ?)) AS drone),
                    freed AS (
                        DELETE FROM virtual_drone_binding
                        WHERE virtual_drone = ? AND drone NOT IN (SELECT drone FROM bound)),
                    taken AS (
                        INSERT INTO virtual_drone_binding (drone, virtual_drone) SELECT drone, ? FROM bound
                        ON CONFLICT (drone, virtual_drone) DO NOTHING)
                INSERT INTO virtual_drone (id, created_at, body) VALUES (?, ?, ?::json)
                ON CONFLICT (id) DO UPDATE SET body = excluded.body""",
                bound,
                BETWEEN,
                drone.id().value(),
                drone.id().value(),
                drone.id().value(),
                drone.createdAt(),
                VirtualDroneJson.write(drone));
    }

    @Override
    public boolean delete(VirtualDroneId id) {
        return sql.update("DELETE FROM virtual_drone WHERE id = ?", id.value()) > 0;
    }

    @Override
    public Set<DroneId> warehouse() {
        return sql.list("SELECT drone_id FROM warehouse_drone", row -> new DroneId(row.text("drone_id"))).stream()
                .collect(Collectors.toUnmodifiableSet());
    }

    @Override
    public void addToWarehouse(DroneId drone) {
        sql.update("INSERT INTO warehouse_drone (drone_id) VALUES (?) ON CONFLICT DO NOTHING", drone.value());
    }

    @Override
    public boolean removeFromWarehouse(DroneId drone) {
        return sql.update("DELETE FROM warehouse_drone WHERE drone_id = ?", drone.value()) > 0;
    }
}
