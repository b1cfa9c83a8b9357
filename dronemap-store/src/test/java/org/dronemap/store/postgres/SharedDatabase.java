package org.dronemap.store.postgres;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.Comparator;
import java.util.stream.Stream;
import org.dronemap.store.postgres.own.OwnPostgres;

/** One real PostgreSQL for all tests of a test JVM: starting one takes seconds. Not for tests in parallel. */
final class SharedDatabase {
    private static final Path DIRECTORY = temporary();
    private static final OwnPostgres OWN = OwnPostgres.start(DIRECTORY);
    private static final Database DATABASE =
            Database.open(new DatabaseSettings(OWN.jdbcUrl(), OWN.user(), OWN.password(), Duration.ofSeconds(30)));

    static {
        Runtime.getRuntime().addShutdownHook(new Thread(SharedDatabase::stop, "stop-shared-database"));
    }

    private SharedDatabase() {}

    static Database empty() {
        try (Connection connection = DATABASE.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(
                    "TRUNCATE drone, known_mission, saved_mission, command, account, sign_in, access_key, link_security,"
                            + " recording, link, link_key, control_lease, organisation, drone_owner, user_group,"
                            + " user_group_member, fleet, access_grant, only_granted, invitation, virtual_drone, warehouse_drone,"
                            + " audit, telemetry, drone_event, flight, operation, operation_journal, outlet_key,"
                            + " outlet_number, robot_key");
            return DATABASE;
        } catch (SQLException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The same tables through a pool of its own, with a ledger that no other test has written in; close it. */
    static Database another() {
        empty();
        return again();
    }

    /** The same with what is in it. */
    static Database again() {
        return Database.open(new DatabaseSettings(OWN.jdbcUrl(), OWN.user(), OWN.password(), Duration.ofSeconds(30)));
    }

    static String url(String database) {
        return "jdbc:postgresql://127.0.0.1:" + OWN.port() + "/" + database;
    }

    static String user() {
        return OWN.user();
    }

    static String password() {
        return OWN.password();
    }

    private static Path temporary() {
        try {
            return Files.createTempDirectory("dronemap-store-test");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void stop() {
        DATABASE.close();
        OWN.close();
        try (Stream<Path> paths = Files.walk(DIRECTORY)) {
            for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
