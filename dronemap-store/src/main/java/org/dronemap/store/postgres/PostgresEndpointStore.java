package org.dronemap.store.postgres;

import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.link.DtlsKey;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.link.SavedEndpoint;

/** Stores added endpoints, the DTLS keys of vehicles and the keys of robots in PostgreSQL. Thread-safe. */
public final class PostgresEndpointStore implements EndpointStore {
    private final SqlTransactions sql;

    PostgresEndpointStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<SavedEndpoint> links() {
        return sql.list(
                "SELECT * FROM link ORDER BY added_at, id COLLATE \"C\"",
                row -> new SavedEndpoint(row.text("id"), row.text("url"), row.text("added_by"), row.time("added_at")));
    }

    @Override
    public boolean addLink(SavedEndpoint link) {
        return sql.update(
                        "INSERT INTO link (id, url, added_by, added_at) VALUES (?, ?, ?, ?) ON CONFLICT DO NOTHING",
                        link.id(),
                        link.url(),
                        link.addedBy(),
                        link.addedAt())
                == 1;
    }

    @Override
    public boolean deleteLink(String id) {
        return sql.update("DELETE FROM link WHERE id = ?", id) > 0;
    }

    @Override
    public List<DtlsKey> keys() {
        return sql.list(
                "SELECT * FROM link_key ORDER BY made_at, identity COLLATE \"C\"",
                row -> new DtlsKey(
                        row.text("identity"),
                        row.text("label"),
                        row.text("sealed_secret"),
                        row.text("made_by"),
                        row.time("made_at")));
    }

    @Override
    public void saveKey(DtlsKey key) {
        sql.update("""
                INSERT INTO link_key (identity, label, sealed_secret, made_by, made_at) VALUES (?, ?, ?, ?, ?)
                ON CONFLICT (identity) DO UPDATE SET label = excluded.label, sealed_secret = excluded.sealed_secret,
                    made_by = excluded.made_by, made_at = excluded.made_at""", key.identity(), key.label(), key.sealedSecret(), key.madeBy(), key.madeAt());
    }

    @Override
    public boolean deleteKey(String identity) {
        return sql.update("DELETE FROM link_key WHERE identity = ?", identity) > 0;
    }

    @Override
    public List<RobotKey> robotKeys() {
        return sql.list(
                "SELECT * FROM robot_key ORDER BY made_at, drone_id COLLATE \"C\"",
                row -> new RobotKey(
                        new DroneId(row.text("drone_id")),
                        row.text("label"),
                        row.result().getInt("system_id"),
                        row.textOrNull("owner_id"),
                        row.text("key_hash"),
                        row.text("made_by"),
                        row.text("made_by_account"),
                        row.time("made_at")));
    }

    @Override
    public void saveRobotKey(RobotKey key) {
        sql.update(
                """
                INSERT INTO robot_key (drone_id, label, system_id, owner_id, key_hash, made_by, made_by_account, made_at)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?)
                ON CONFLICT (drone_id) DO UPDATE SET label = excluded.label, system_id = excluded.system_id,
                    owner_id = excluded.owner_id, key_hash = excluded.key_hash, made_by = excluded.made_by,
                    made_by_account = excluded.made_by_account, made_at = excluded.made_at""",
                key.drone().value(),
                key.label(),
                key.systemId(),
                key.owner(),
                key.hash(),
                key.madeBy(),
                key.account(),
                key.madeAt());
    }

    @Override
    public boolean deleteRobotKey(DroneId drone) {
        return sql.update("DELETE FROM robot_key WHERE drone_id = ?", drone.value()) > 0;
    }
}
