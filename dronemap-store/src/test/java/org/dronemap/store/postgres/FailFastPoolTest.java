package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.awaitility.Awaitility.await;

import com.zaxxer.hikari.HikariConfig;
import com.zaxxer.hikari.HikariDataSource;
import java.lang.reflect.Proxy;
import java.sql.Connection;
import java.sql.SQLException;
import java.time.Duration;
import java.util.Map;
import javax.sql.DataSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A database out of reach is waited for once, and found again. */
class FailFastPoolTest {
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    private volatile boolean reachable = true;
    private final HikariDataSource below = pool(1);
    private final FailFastPool pool = new FailFastPool(below);

    private HikariDataSource pool(int connections) {
        HikariConfig config = new HikariConfig();
        config.setDataSource(stub(DataSource.class, this::connection));
        config.setMaximumPoolSize(connections);
        config.setConnectionTimeout(250);
        config.setInitializationFailTimeout(-1);
        return new HikariDataSource(config);
    }

    private Connection connection() throws SQLException {
        if (!reachable) {
            throw new SQLException("nobody listens there", "08001");
        }
        return stub(Connection.class, () -> null);
    }

    /** Something that may fail as a database does. */
    private interface DatabaseCall {
        Object give() throws SQLException;
    }

    /** Answers what it is asked for by {@code answer} if that is a connection, and that all is well otherwise. */
    private static <T> T stub(Class<T> type, DatabaseCall answer) {
        Map<Class<?>, Object> well = Map.of(boolean.class, true, int.class, Connection.TRANSACTION_READ_COMMITTED);
        return type.cast(Proxy.newProxyInstance(
                type.getClassLoader(),
                new Class<?>[] {type},
                (self, method, arguments) ->
                        method.getReturnType() == Connection.class ? answer.give() : well.get(method.getReturnType())));
    }

    @AfterEach
    void close() {
        pool.close();
    }

    @Test
    void refusesAtOnceWhatItKnowsToBeOutOfReachAndFindsItAgain() throws SQLException {
        pool.getConnection().close();
        reachable = false;
        below.getHikariPoolMXBean().softEvictConnections();
        SQLException first = refusal();
        assertThat(SqlErrorMessages.of(first)).isEqualTo("The database cannot be reached: " + first.getMessage());

        SQLException second = refusal();

        assertThat(second.getCause()).as("what somebody else waited for").isInstanceOf(SQLException.class);
        assertThat(second.getStackTrace()[0].getClassName()).isEqualTo(FailFastPool.class.getName());
        assertThat(SqlErrorMessages.isOutOfReach(second)).isTrue();

        reachable = true;
        await().atMost(PATIENCE).until(this::answers);
    }

    @Test
    void takesABusyDatabaseForNoneThatIsAway() throws SQLException {
        try (Connection only = pool.getConnection()) {
            assertThat(only).isNotNull();
            refusal();
        }

        pool.getConnection().close();
    }

    private SQLException refusal() {
        return catchThrowableOfType(SQLException.class, pool::getConnection);
    }

    private boolean answers() {
        try (Connection connection = pool.getConnection()) {
            return connection != null;
        } catch (SQLException e) {
            return false;
        }
    }
}
