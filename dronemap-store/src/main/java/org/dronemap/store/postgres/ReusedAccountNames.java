package org.dronemap.store.postgres;

import java.time.Instant;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Warns in the server's log of user names that two accounts had, one after the other, before accounts had ids. */
final class ReusedAccountNames {
    private static final Logger LOG = LoggerFactory.getLogger(ReusedAccountNames.class);

    private record Reused(String name, Instant removedAt) {}

    private ReusedAccountNames() {}

    static void logWarnings(SqlTransactions sql) {
        sql.list(
                        "SELECT name, removed_at FROM reused_name ORDER BY name",
                        row -> new Reused(row.text("name"), row.time("removed_at")))
                .forEach(one -> LOG.warn(
                        "The name {} was of two users: virtual drones and operations from before {} belong to the one who was"
                                + " removed then, and are no longer today's user's; a supervisor sees them.",
                        one.name(),
                        one.removedAt()));
    }
}
