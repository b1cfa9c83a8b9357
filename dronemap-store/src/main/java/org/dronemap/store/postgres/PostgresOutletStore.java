package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.OutletKey;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.access.OutletSystemId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.store.secret.SecretBox;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stores in PostgreSQL users' sealed outlet keys, and the system ids by which their ground stations know drones.
 * Thread-safe.
 */
public final class PostgresOutletStore implements OutletStore {
    private static final Logger LOG = LoggerFactory.getLogger(PostgresOutletStore.class);

    private final SqlTransactions sql;
    private final SecretBox box;

    PostgresOutletStore(SqlTransactions sql, SecretBox box) {
        this.sql = sql;
        this.box = box;
    }

    @Override
    public List<OutletKey> keys() {
        return sql.list("SELECT * FROM outlet_key ORDER BY account", this::key).stream()
                .flatMap(Optional::stream)
                .toList();
    }

    /** A key that does not open is no key: its user stays outside until a new passphrase is set. */
    private Optional<OutletKey> key(ResultRow row) throws SQLException {
        String user = row.text("account");
        Optional<byte[]> secret = box.open(row.text("sealed_key"), place(user));
        if (secret.isEmpty()) {
            LOG.error(
                    "The outlet's key of {} was sealed with another server secret; bring that secret back and start"
                            + " again, or set a new passphrase",
                    user);
            return Optional.empty();
        }
        return Optional.of(
                new OutletKey(user, new LinkKey(secret.get()), row.result().getLong("stamp")));
    }

    @Override
    public void saveKey(OutletKey key) {
        sql.update("""
                INSERT INTO outlet_key (account, sealed_key, stamp) VALUES (?, ?, ?)
                ON CONFLICT (account) DO UPDATE SET sealed_key = excluded.sealed_key,
                    stamp = greatest(outlet_key.stamp, excluded.stamp)""", key.user(), box.seal(key.key().secret(), place(key.user())), key.stamp());
    }

    @Override
    public void saveStamp(String user, long stamp) {
        sql.update("UPDATE outlet_key SET stamp = ? WHERE account = ? AND stamp < ?", stamp, user, stamp);
    }

    @Override
    public boolean deleteKey(String user) {
        return sql.update("DELETE FROM outlet_key WHERE account = ?", user) > 0;
    }

    @Override
    public List<OutletSystemId> numbers() {
        return sql.list(
                "SELECT * FROM outlet_number ORDER BY account, system_id",
                row -> new OutletSystemId(
                        row.text("account"),
                        new DroneId(row.text("drone_id")),
                        row.result().getInt("system_id")));
    }

    @Override
    public void saveNumber(OutletSystemId number) {
        sql.update("""
                INSERT INTO outlet_number (account, drone_id, system_id)
                SELECT account.name, drone.id, ? FROM account, drone WHERE account.name = ? AND drone.id = ?
                ON CONFLICT DO NOTHING""", number.systemId(), number.user(), number.drone().value());
    }

    private static String place(String user) {
        return "outlet of " + user;
    }
}
