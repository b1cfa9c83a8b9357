package org.dronemap.store.postgres;

import com.zaxxer.hikari.HikariDataSource;
import java.io.PrintWriter;
import java.sql.Connection;
import java.sql.SQLException;
import java.sql.SQLFeatureNotSupportedException;
import java.sql.SQLTransientConnectionException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.logging.Logger;
import javax.sql.DataSource;
import org.dronemap.core.time.FatalErrors;
import org.jspecify.annotations.Nullable;

/**
 * A database connection pool that refuses at once while the database is out of reach, instead of letting callers wait.
 * Several waits in a row, or many callers in one queue, would delay what brings a drone to safety. Meanwhile one thread
 * looks for the database. Thread-safe.
 */
final class FailFastPool implements DataSource, AutoCloseable {
    private static final int LONGEST_CHECK_SECONDS = 3;
    private static final long BETWEEN_LOOKS_MILLIS = 100;

    private final HikariDataSource pool;
    /** Why it is out of reach; null while it is not known to be. */
    private final AtomicReference<@Nullable SQLException> away = new AtomicReference<>();

    FailFastPool(HikariDataSource pool) {
        this.pool = pool;
    }

    @Override
    public Connection getConnection() throws SQLException {
        SQLException why = away.get();
        if (why != null) {
            throw new SQLTransientConnectionException(why.getMessage(), why.getSQLState(), why);
        }
        try {
            return pool.getConnection();
        } catch (SQLTransientConnectionException e) {
            // Without a cause all connections are busy: that is no database out of reach.
            if (e.getCause() != null && away.compareAndSet(null, e)) {
                Thread search = FatalErrors.onDuty(new Thread(this::awaitDatabase, "database-search"));
                search.setDaemon(true);
                search.start();
            }
            throw e;
        }
    }

    private void awaitDatabase() {
        try {
            while (!pool.isClosed() && !isThere()) {
                Thread.sleep(BETWEEN_LOOKS_MILLIS);
            }
            away.set(null);
        } catch (InterruptedException e) {
            away.set(null);
            Thread.currentThread().interrupt();
        }
    }

    private boolean isThere() {
        try (Connection connection = pool.getConnection()) {
            return connection.isValid(LONGEST_CHECK_SECONDS);
        } catch (SQLException e) {
            away.set(e);
            return false;
        }
    }

    @Override
    public void close() {
        pool.close();
    }

    @Override
    public Connection getConnection(String user, String password) throws SQLException {
        throw new SQLFeatureNotSupportedException("connections have the pool's own user");
    }

    @Override
    public PrintWriter getLogWriter() throws SQLException {
        return pool.getLogWriter();
    }

    @Override
    public void setLogWriter(PrintWriter out) throws SQLException {
        pool.setLogWriter(out);
    }

    @Override
    public void setLoginTimeout(int seconds) throws SQLException {
        pool.setLoginTimeout(seconds);
    }

    @Override
    public int getLoginTimeout() throws SQLException {
        return pool.getLoginTimeout();
    }

    @Override
    public Logger getParentLogger() throws SQLFeatureNotSupportedException {
        return pool.getParentLogger();
    }

    @Override
    public <T> T unwrap(Class<T> type) throws SQLException {
        return pool.unwrap(type);
    }

    @Override
    public boolean isWrapperFor(Class<?> type) throws SQLException {
        return pool.isWrapperFor(type);
    }
}
