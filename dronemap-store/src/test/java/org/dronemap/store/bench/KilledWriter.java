package org.dronemap.store.bench;

import java.nio.file.Path;
import java.time.Instant;
import org.dronemap.store.postgres.PostgresStores;

/** Remembers states of now until it is killed. Arguments: directory of the database, states a second. */
public final class KilledWriter {
    static final String UNDER_WAY = "under way";

    private KilledWriter() {}

    public static void main(String[] arguments) {
        try (PostgresStores database = PostgresStores.openOwn(Path.of(arguments[0]));
                OpenLoopLoad loop = new OpenLoopLoad(database, Integer.parseInt(arguments[1]))) {
            System.out.println(UNDER_WAY);
            loop.bring(Long.MAX_VALUE, number -> Instant.now());
        }
    }
}
