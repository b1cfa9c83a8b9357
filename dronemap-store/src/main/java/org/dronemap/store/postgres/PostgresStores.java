package org.dronemap.store.postgres;

import com.zaxxer.hikari.HikariConfig;
import com.zaxxer.hikari.HikariDataSource;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.time.Duration;
import java.util.Properties;
import javax.sql.DataSource;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.history.FlightStore;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.recording.RecordingStore;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.store.CachedAccessStore;
import org.dronemap.store.StoreException;
import org.dronemap.store.Stores;
import org.dronemap.store.postgres.bundled.BundledPostgres;
import org.dronemap.store.secret.SecretBox;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** An open PostgreSQL database whose schema is up to date, with all stores of the server in it. Thread-safe. */
public final class PostgresStores implements Stores {
    /** The schema that holds everything, so that a database shared with others keeps apart. */
    static final String SCHEMA = "dronemap";

    private static final Logger LOG = LoggerFactory.getLogger(PostgresStores.class);
    private static final int MAX_CONNECTIONS = 8;
    private static final Duration PAUSE_BETWEEN_TRIES = Duration.ofMillis(100);

    private final FailFastPool pool;
    private final @Nullable BundledPostgres own;
    private final DatabaseWritability writability = new DatabaseWritability();
    private final AuditLedger ledger;
    private final SqlTransactions sql;
    private final AccessStore access;

    private PostgresStores(FailFastPool pool, @Nullable BundledPostgres own) {
        this.pool = pool;
        this.own = own;
        this.ledger = new AuditLedger(pool, writability);
        this.sql = new SqlTransactions(pool, ledger);
        this.access = new CachedAccessStore(new PostgresAccessStore(sql), System::nanoTime);
    }

    /** Opens somebody else's PostgreSQL, waiting for it as long as the settings say. */
    public static PostgresStores open(DatabaseSettings settings) {
        waitFor(settings);
        FailFastPool pool = pool(settings);
        try {
            new Migration(pool).toLatest(SCHEMA);
            PostgresStores database = new PostgresStores(pool, null);
            ReusedAccountNames.logWarnings(database.sql);
            return database;
        } catch (RuntimeException e) {
            pool.close();
            throw e;
        }
    }

    /** Opens the server's own PostgreSQL in {@code directory}, and stops it on {@link #close}. */
    public static PostgresStores openOwn(Path directory) {
        BundledPostgres own = BundledPostgres.start(directory);
        try {
            PostgresStores opened =
                    open(new DatabaseSettings(own.jdbcUrl(), own.user(), own.password(), Duration.ofSeconds(30)));
            return new PostgresStores(opened.pool, own);
        } catch (RuntimeException e) {
            own.close();
            throw e;
        }
    }

    public DataSource dataSource() {
        return pool;
    }

    @Override
    public DroneStore drones() {
        return new PostgresDroneStore(sql);
    }

    @Override
    public MissionStore missions() {
        return new PostgresMissionStore(sql);
    }

    @Override
    public ZoneStore zones() {
        return new PostgresZoneStore(sql);
    }

    @Override
    public CommandStore commands() {
        return new PostgresCommandStore(sql);
    }

    /** Who was recognised lately is recognised while the database is away, too. */
    @Override
    public AccessStore access() {
        return access;
    }

    @Override
    public GrantStore grants() {
        return new PostgresGrantStore(sql);
    }

    /** Keys are sealed with {@code box} on their way in. */
    @Override
    public LinkSecurityStore linkSecurity(SecretBox box) {
        return new PostgresLinkSecurityStore(sql, box);
    }

    /** Keys are sealed with {@code box} on their way in. */
    @Override
    public OutletStore outlet(SecretBox box) {
        return new PostgresOutletStore(sql, box);
    }

    @Override
    public RecordingStore recordings() {
        return new PostgresRecordingStore(sql);
    }

    @Override
    public EndpointStore links() {
        return new PostgresEndpointStore(sql);
    }

    @Override
    public LeaseStore leases() {
        return new PostgresLeaseStore(sql);
    }

    @Override
    public ParameterOverrideStore owners() {
        return new PostgresParameterOverrideStore(sql);
    }

    /** From now on each change takes along the record of the call that it belongs to. Once. */
    @Override
    public AuditStore audit(AuditChain chain) {
        ledger.open(chain);
        return new PostgresAuditStore(sql, ledger);
    }

    @Override
    public VirtualDroneStore virtualDrones() {
        return new PostgresVirtualDroneStore(sql);
    }

    @Override
    public OperationStore operations() {
        return new PostgresOperationStore(sql);
    }

    @Override
    public TelemetryStore telemetry() {
        return new PostgresTelemetryStore(pool);
    }

    @Override
    public FlightStore flights() {
        return new PostgresFlightStore(sql);
    }

    public Backup backup() {
        return new Backup(pool, SCHEMA);
    }

    @Override
    public boolean isUp() {
        return health().isUp();
    }

    @Override
    public void backUp(OutputStream out) throws IOException {
        BackupSummary summary = backup().write(out);
        LOG.info("A backup was written: {}", summary);
    }

    /** Whether the database answers now, and took the last change. Blocks up to some seconds. */
    public DatabaseHealth health() {
        String trouble = writability.trouble();
        if (trouble != null) {
            return new DatabaseHealth.Down(trouble);
        }
        try (Connection connection = pool.getConnection()) {
            return connection.isValid(3)
                    ? new DatabaseHealth.Up()
                    : new DatabaseHealth.Down("The database does not answer.");
        } catch (SQLException e) {
            return new DatabaseHealth.Down(SqlErrorMessages.of(e));
        }
    }

    @Override
    public void close() {
        ledger.close();
        pool.close();
        if (own != null) {
            own.close();
        }
    }

    private static FailFastPool pool(DatabaseSettings settings) {
        HikariConfig config = new HikariConfig();
        config.setPoolName("database");
        config.setJdbcUrl(settings.jdbcUrl());
        if (settings.user() != null) {
            config.setUsername(settings.user());
        }
        if (settings.password() != null) {
            config.setPassword(settings.password());
        }
        config.setMaximumPoolSize(MAX_CONNECTIONS);
        config.setMinimumIdle(1);
        config.setConnectionTimeout(5_000);
        config.setSchema(SCHEMA);
        config.setConnectionInitSql(
                "SELECT set_config('synchronous_commit', 'on', false) WHERE current_setting('synchronous_commit') = 'off'");
        config.addDataSourceProperty("ApplicationName", "dronemap");
        config.addDataSourceProperty("connectTimeout", "5");
        config.addDataSourceProperty("socketTimeout", "60");
        config.addDataSourceProperty("tcpKeepAlive", "true");
        return new FailFastPool(new HikariDataSource(config));
    }

    /** Asks without the pool, which would hide what the database says behind timeouts of its own. */
    private static void waitFor(DatabaseSettings settings) {
        long deadline = System.nanoTime() + settings.patience().toNanos();
        boolean told = false;
        while (true) {
            try (Connection connection = DriverManager.getConnection(settings.jdbcUrl(), login(settings))) {
                if (connection.isValid(5)) {
                    return;
                }
                throw new SQLException("no answer", "08006");
            } catch (SQLException e) {
                if (!SqlErrorMessages.isOutOfReach(e) || System.nanoTime() >= deadline) {
                    throw new StoreException(SqlErrorMessages.of(e) + " (" + settings + ")", e);
                }
                if (!told) {
                    LOG.info(
                            "Waiting up to {} s for the database {}",
                            settings.patience().toSeconds(),
                            settings);
                    told = true;
                }
                pause();
            }
        }
    }

    private static Properties login(DatabaseSettings settings) {
        Properties login = new Properties();
        login.setProperty("connectTimeout", "5");
        login.setProperty("socketTimeout", "10");
        if (settings.user() != null) {
            login.setProperty("user", settings.user());
        }
        if (settings.password() != null) {
            login.setProperty("password", settings.password());
        }
        return login;
    }

    private static void pause() {
        try {
            Thread.sleep(PAUSE_BETWEEN_TRIES.toMillis());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new StoreException("Interrupted while waiting for the database.", e);
        }
    }
}
