package org.dronemap.store.postgres;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.List;
import org.dronemap.store.postgres.bundled.BundledPostgres;
import org.dronemap.store.postgres.bundled.TestDatabaseDirectories;

/**
 * One real PostgreSQL for all tests of a test JVM: starting one takes seconds. It does not wait for the disk, since no power cut
 * is survived here; that the server's own one does is told by its own tests. Not for tests in parallel.
 */
final class SharedDatabase {
    private static final Path DIRECTORY = temporary();
    private static final BundledPostgres OWN = start();
    private static final PostgresStores DATABASE = PostgresStores.open(
            new DatabaseSettings(OWN.jdbcUrl(), OWN.user(), OWN.password(), Duration.ofSeconds(30)));

    /** Only of those that hold something, since each table that is emptied has its files made anew, also an empty one. */
    private static final String EMPTY = """
            DO $$
            DECLARE
                name text;
                filled boolean;
                all_filled text[] := '{}';
            BEGIN
                FOREACH name IN ARRAY ARRAY['drone', 'known_mission', 'saved_mission', 'command', 'account', 'sign_in',
                        'access_key', 'link_security', 'recording', 'link', 'link_key', 'control_lease', 'owners_values',
                        'organisation',
                        'drone_owner', 'drone_gift', 'user_group', 'user_group_member', 'fleet', 'access_grant', 'only_granted',
                        'invitation', 'virtual_drone', 'virtual_drone_binding', 'warehouse_drone', 'audit', 'telemetry', 'drone_event', 'flight',
                        'operation', 'operation_journal', 'outlet_key', 'outlet_number', 'robot_key',
                        'reused_name', 'event_gap'] LOOP
                    EXECUTE 'SELECT EXISTS (SELECT FROM ' || name || ')' INTO filled;
                    IF filled THEN
                        all_filled := all_filled || name;
                    END IF;
                END LOOP;
                IF all_filled <> '{}' THEN
                    EXECUTE 'TRUNCATE ' || array_to_string(all_filled, ', ') || ' CASCADE';
                END IF;
                UPDATE event_series SET opened_at = NULL, expired = 0, expired_before = NULL;
            END $$
            """;

    static {
        Runtime.getRuntime().addShutdownHook(new Thread(SharedDatabase::stop, "stop-shared-database"));
    }

    private SharedDatabase() {}

    private static BundledPostgres start() {
        TestDatabaseDirectories.putPrograms(DIRECTORY);
        BundledPostgres own = BundledPostgres.start(DIRECTORY);
        try (Connection connection = DriverManager.getConnection(own.jdbcUrl(), own.user(), own.password());
                Statement statement = connection.createStatement()) {
            for (String setting : List.of("fsync", "full_page_writes")) {
                statement.execute("ALTER SYSTEM SET " + setting + " = off");
            }
            statement.execute("SELECT pg_reload_conf()");
            return own;
        } catch (SQLException e) {
            throw new IllegalStateException(e);
        }
    }

    static PostgresStores empty() {
        try (Connection connection = DATABASE.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(EMPTY);
            return DATABASE;
        } catch (SQLException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The same tables through a pool of its own, with a ledger that no other test has written in; close it. */
    static PostgresStores another() {
        empty();
        return again();
    }

    /** The same with what is in it. */
    static PostgresStores again() {
        return PostgresStores.open(
                new DatabaseSettings(OWN.jdbcUrl(), OWN.user(), OWN.password(), Duration.ofSeconds(30)));
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
        TestDatabaseDirectories.delete(DIRECTORY);
    }
}
