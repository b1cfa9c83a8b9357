package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.store.secret.SecretBox;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stores each drone's signing policy, sealed MAVLink signing keys and last signing stamp in PostgreSQL. Thread-safe.
 */
public final class PostgresLinkSecurityStore implements LinkSecurityStore {
    private static final Logger LOG = LoggerFactory.getLogger(PostgresLinkSecurityStore.class);
    private static final String KEY = "key";
    private static final String NEXT = "next key";

    private final SqlTransactions sql;
    private final SecretBox box;

    PostgresLinkSecurityStore(SqlTransactions sql, SecretBox box) {
        this.sql = sql;
        this.box = box;
    }

    @Override
    public List<LinkSecurity> all() {
        return sql.list("SELECT * FROM link_security ORDER BY drone_id", this::security);
    }

    @Override
    public void save(LinkSecurity security) {
        sql.update(
                """
                INSERT INTO link_security (drone_id, policy, sealed_key, sealed_next_key, proven, stamp)
                VALUES (?, ?, ?, ?, ?, ?)
                ON CONFLICT (drone_id) DO UPDATE SET policy = excluded.policy, sealed_key = excluded.sealed_key,
                    sealed_next_key = excluded.sealed_next_key, proven = excluded.proven,
                    stamp = greatest(link_security.stamp, excluded.stamp)""",
                security.drone().value(),
                security.policy(),
                sealed(security.key(), security.drone(), KEY),
                sealed(security.nextKey(), security.drone(), NEXT),
                security.proven(),
                security.stamp());
    }

    @Override
    public void saveStamp(DroneId drone, long stamp) {
        sql.update("UPDATE link_security SET stamp = ? WHERE drone_id = ? AND stamp < ?", stamp, drone.value(), stamp);
    }

    private LinkSecurity security(ResultRow row) throws SQLException {
        DroneId drone = new DroneId(row.text("drone_id"));
        LinkKey key = opened(row.textOrNull("sealed_key"), drone, KEY);
        return new LinkSecurity(
                drone,
                row.name("policy", LinkSigningPolicy.class),
                key,
                key == null ? null : opened(row.textOrNull("sealed_next_key"), drone, NEXT),
                key != null && row.bool("proven"),
                row.result().getLong("stamp"));
    }

    private @Nullable String sealed(@Nullable LinkKey key, DroneId drone, String which) {
        return key == null ? null : box.seal(key.secret(), place(drone, which));
    }

    /** A key that does not open is no key: its drone stays as closed as its policy says until a new one is made. */
    private @Nullable LinkKey opened(@Nullable String sealed, DroneId drone, String which) {
        if (sealed == null) {
            return null;
        }
        Optional<byte[]> secret = box.open(sealed, place(drone, which));
        if (secret.isEmpty()) {
            LOG.error(
                    "The {} of drone {} was sealed with another server secret; bring that secret back and start again, or"
                            + " make a new key for the drone",
                    which,
                    drone);
        }
        return secret.map(LinkKey::new).orElse(null);
    }

    private static String place(DroneId drone, String which) {
        return which + " of " + drone.value();
    }
}
