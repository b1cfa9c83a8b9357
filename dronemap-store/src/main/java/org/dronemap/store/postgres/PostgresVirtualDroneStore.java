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
        DroneId bound = drone.boundTo();
        sql.update(
                """
                INSERT INTO virtual_drone (id, created_at, bound_drone, body) VALUES (?, ?, ?, ?::json)
                ON CONFLICT (id) DO UPDATE SET bound_drone = excluded.bound_drone, body = excluded.body""",
                drone.id().value(),
                drone.createdAt(),
                bound == null ? null : bound.value(),
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
