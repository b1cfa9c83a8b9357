package org.dronemap.store.postgres.bundled;

import java.nio.file.Path;
import java.time.Instant;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.store.postgres.PostgresStores;

/** A program that opens its own database and writes commands until it is killed, naming each once it is kept. */
final class KilledDatabaseWriter {
    private KilledDatabaseWriter() {}

    /** Arguments: the data directory, a prefix for command ids, and how many to write (then it waits to be killed). */
    public static void main(String[] arguments) throws InterruptedException {
        PostgresStores database = PostgresStores.openOwn(Path.of(arguments[0]));
        System.out.println("ready");
        int count = Integer.parseInt(arguments[2]);
        for (int i = 0; i < count; i++) {
            String id = arguments[1] + "-" + i;
            if (database.commands().begin(command(id))) {
                System.out.println(id);
            }
        }
        System.out.println("done");
        Thread.currentThread().join();
    }

    static CommandRecord command(String id) {
        return new CommandRecord(
                new CommandId(id),
                new DroneId("copter-1"),
                "alice",
                "rest",
                "arm",
                "arm",
                Instant.EPOCH,
                CommandPhase.SENT,
                null,
                null,
                null,
                null);
    }
}
