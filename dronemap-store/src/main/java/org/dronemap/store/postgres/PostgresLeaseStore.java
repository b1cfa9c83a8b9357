package org.dronemap.store.postgres;

import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.lease.SavedLease;
import org.dronemap.store.StoreException;

/** Stores the leases of control over drones in PostgreSQL. Thread-safe. */
public final class PostgresLeaseStore implements LeaseStore {
    private final SqlTransactions sql;

    PostgresLeaseStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<SavedLease> leases() {
        return sql.list(
                "SELECT * FROM control_lease ORDER BY drone_id COLLATE \"C\"",
                row -> new SavedLease(
                        new DroneId(row.text("drone_id")),
                        row.text("account_name"),
                        row.time("since"),
                        row.longInteger("epoch"),
                        row.bool("lapsed"),
                        row.textOrNull("mode")));
    }

    @Override
    public void save(SavedLease lease) {
        sql.update(
                """
                INSERT INTO control_lease (drone_id, account_name, since, epoch, lapsed, mode)
                VALUES (?, ?, ?, ?, ?, ?)
                ON CONFLICT (drone_id) DO UPDATE SET account_name = excluded.account_name, since = excluded.since,
                    epoch = excluded.epoch, lapsed = excluded.lapsed, mode = excluded.mode""", lease.drone().value(), lease.user(), lease.since(), lease.epoch(), lease.lapsed(), lease.mode());
    }

    @Override
    public void delete(DroneId drone) {
        sql.update("DELETE FROM control_lease WHERE drone_id = ?", drone.value());
    }

    @Override
    public long reserve(int count) {
        return sql.one(
                        "UPDATE control_epoch SET reserved = reserved + ? RETURNING reserved",
                        row -> row.longInteger("reserved"),
                        count)
                .orElseThrow(() -> new StoreException("The row of epochs is gone."));
    }
}
