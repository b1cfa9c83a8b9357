package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class PostgresStoresTest {
    private static final String NAME = "somebody_elses";

    private String url;
    private String password;

    @BeforeEach
    void createAnotherDatabase() throws SQLException {
        url = SharedDatabase.url(NAME);
        password = SharedDatabase.password();
        onServer("DROP DATABASE IF EXISTS " + NAME + " WITH (FORCE)");
        onServer("CREATE DATABASE " + NAME);
    }

    @AfterEach
    void dropIt() throws SQLException {
        onServer("DROP DATABASE IF EXISTS " + NAME + " WITH (FORCE)");
    }

    @Test
    void migratesAnEmptyDatabaseAndFindsItAgain() throws SQLException {
        User alice = new User("alice", Role.VIEWER, AccountState.ACTIVE, "hash", false);
        try (PostgresStores first = open(password)) {
            assertThat(first.access().addUser(alice)).isTrue();
            assertThat(text(first, "SELECT string_agg(version, ',') FROM schema_history WHERE version IS NOT NULL"))
                    .matches("1(,\\d+)*");
        }
        try (PostgresStores second = open(password)) {
            assertThat(second.access().users()).extracting(User::name).containsExactly("alice");
            assertThat(second.health().isUp()).isTrue();
        }
    }

    @Test
    void leavesTheTablesOfOthersAlone() throws SQLException {
        try (PostgresStores first = open(password);
                Connection connection = first.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute("DROP SCHEMA dronemap CASCADE");
            statement.execute("CREATE TABLE public.drone (theirs integer)");
        }
        try (PostgresStores second = open(password)) {
            assertThat(second.drones().drones()).isEmpty();
            assertThat(text(second, "SELECT count(*)::text FROM public.drone")).isEqualTo("0");
        }
    }

    @Test
    void refusesADatabaseThatANewerProgramWrote() throws SQLException {
        try (PostgresStores first = open(password);
                Connection connection = first.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute("INSERT INTO schema_history (installed_rank, version, description, type, script,"
                    + " installed_by, execution_time, success)"
                    + " VALUES (99, '9999', 'future', 'SQL', 'V9999__future.sql', 'x', 1, true)");
        }
        assertThatThrownBy(() -> open(password))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("written by a newer Dronemap (schema 9999, this one knows up to ");
    }

    @Test
    void turnsOnDurableCommitsWhereTheyAreOff() throws SQLException {
        onServer("ALTER DATABASE " + NAME + " SET synchronous_commit = off");
        try (PostgresStores database = open(password)) {
            assertThat(text(database, "SHOW synchronous_commit")).isEqualTo("on");
        }
    }

    @Test
    @Timeout(10)
    void saysAtOnceThatAPasswordIsWrongWithoutRepeatingIt() {
        assertThatThrownBy(() -> open("open-sesame"))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("does not accept the user or password")
                .hasMessageNotContaining("open-sesame");
    }

    @Test
    @Timeout(10)
    void saysAtOnceThatADatabaseDoesNotExist() {
        DatabaseSettings settings = DatabaseSettings.of(
                SharedDatabase.url("nowhere") + "?user=" + SharedDatabase.user() + "&password=" + password);
        assertThatThrownBy(() -> PostgresStores.open(settings))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("That database does not exist")
                .hasMessageNotContaining(password);
    }

    @Test
    void givesUpOnADatabaseThatIsNotThere() throws IOException {
        int closed;
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            closed = socket.getLocalPort();
        }
        DatabaseSettings settings = DatabaseSettings.of("postgresql://u:secret@127.0.0.1:" + closed + "/d")
                .withPatience(Duration.ofMillis(10));
        assertThatThrownBy(() -> PostgresStores.open(settings))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("The database cannot be reached")
                .hasMessageContaining("127.0.0.1:" + closed)
                .hasMessageNotContaining("secret");
    }

    private PostgresStores open(String withPassword) {
        return PostgresStores.open(
                new DatabaseSettings(url, SharedDatabase.user(), withPassword, Duration.ofSeconds(20)));
    }

    private static String text(PostgresStores database, String sql) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery(sql)) {
            assertThat(result.next()).isTrue();
            return result.getString(1);
        }
    }

    private static void onServer(String sql) throws SQLException {
        try (Connection connection = SharedDatabase.empty().dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }
}
