package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A server of PostgreSQL that answers, and has no room left for changes: it says so with SQLSTATE 53100. */
class FullDiskTest {
    private static final User ANN = new User("ann", Role.VIEWER, AccountState.ACTIVE, "hash", false);
    private static final User BOB = new User("bob", Role.VIEWER, AccountState.ACTIVE, "hash", false);

    private final PostgresStores database = SharedDatabase.another();

    @BeforeEach
    void fill() throws SQLException {
        database.audit(PostgresAuditStoreTest.CHAIN);
        execute("""
                CREATE FUNCTION is_full() RETURNS trigger LANGUAGE plpgsql AS $$
                BEGIN RAISE EXCEPTION 'could not extend file: No space left on device' USING ERRCODE = '53100'; END $$""");
        execute("CREATE TRIGGER is_full BEFORE INSERT ON account EXECUTE FUNCTION is_full()");
    }

    @AfterEach
    void close() throws SQLException {
        makeRoom();
        database.close();
    }

    private void makeRoom() throws SQLException {
        execute("DROP FUNCTION IF EXISTS is_full CASCADE");
    }

    private void execute(String sql) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    private void addInACall(User user) {
        new AuditedCall(
                        PostgresAuditStoreTest.entry("alice", "POST /api/v1/users", null, AuditOutcome.SUCCEEDED),
                        System::nanoTime)
                .during(() -> database.access().addUser(user));
    }

    @Test
    void whatFindsNoRoomIsAPassingFailureAndHealthSaysSo() throws SQLException {
        assertThat(database.health().isUp()).isTrue();
        assertThatThrownBy(() -> addInACall(ANN))
                .isInstanceOfSatisfying(
                        StoreException.class,
                        full -> assertThat(full.isTransient()).isTrue())
                .hasMessageStartingWith("The disk of the database is full");
        assertThat(database.health())
                .isInstanceOfSatisfying(
                        DatabaseHealth.Down.class,
                        down -> assertThat(down.why()).startsWith("The disk of the database is full"));

        makeRoom();
        addInACall(ANN);
        assertThat(database.health().isUp()).isTrue();
    }

    @Test
    void theSameHoldsForChangesOfNoCall() throws SQLException {
        assertThatThrownBy(() -> database.access().addUser(ANN))
                .isInstanceOfSatisfying(
                        StoreException.class,
                        full -> assertThat(full.isTransient()).isTrue());
        assertThat(database.health().isUp()).isFalse();

        makeRoom();
        assertThat(database.access().addUser(BOB)).isTrue();
        assertThat(database.health().isUp()).isTrue();
    }
}
