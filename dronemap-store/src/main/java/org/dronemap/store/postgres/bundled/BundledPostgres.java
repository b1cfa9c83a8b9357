package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.dronemap.store.StoreException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The PostgreSQL that a server starts and stops itself when it is given no database. A database that outlived a killed
 * server is taken over, unless other programs than ours run it: their weaknesses may be why there are new ones. One
 * that crashed recovers at its start. Thread-safe.
 */
public final class BundledPostgres implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(BundledPostgres.class);
    private static final String USER = "dronemap";
    private static final String DATABASE = "dronemap";

    /** How long an orphan may take to answer: it may be recovering itself. */
    private static final Duration ADOPTION_LIMIT = Duration.ofSeconds(30);

    private static final Duration BETWEEN_LOOKS = Duration.ofMillis(50);

    /** How often the guard looks whether the database still lives. */
    private static final Duration GUARD_PERIOD = Duration.ofMillis(500);

    private final DirectoryLock lock;
    private final DatabaseCluster cluster;
    private final String password;
    private final int port;
    private final boolean adopted;
    private final ScheduledExecutorService guard =
            Executors.newSingleThreadScheduledExecutor(BundledPostgres::guardThread);
    private boolean closed;

    private BundledPostgres(DirectoryLock lock, DatabaseCluster cluster, String password) {
        this.lock = lock;
        this.cluster = cluster;
        this.password = password;
        Optional<PostmasterFile> orphan = adopt();
        this.adopted = orphan.isPresent();
        this.port = orphan.isPresent() ? orphan.get().port() : cluster.start();
        createDatabase();
    }

    private static Thread guardThread(Runnable work) {
        Thread thread = new Thread(work, "own-postgres-guard");
        thread.setDaemon(true);
        return thread;
    }

    /** Starts it, or takes over one that still runs; throws {@link StoreException} with a sentence when it cannot. */
    public static BundledPostgres start(Path directory) {
        Path home = prepare(directory);
        DirectoryLock lock = DirectoryLock.acquire(home);
        try {
            String password = DatabasePasswordFile.readOrCreate(home.resolve("password"));
            DatabaseCluster cluster = new DatabaseCluster(home, PostgresBinaries.unpack(home), ProcessAccount.of(home));
            cluster.createIfMissing(USER, password);
            BundledPostgres own = new BundledPostgres(lock, cluster, password);
            own.keepAlive();
            return own;
        } catch (RuntimeException e) {
            lock.close();
            throw e;
        }
    }

    /** Stops a database that outlived its server; true when there was one. Refused while a server holds it. */
    public static boolean stopOrphan(Path directory) {
        if (Files.notExists(DatabaseCluster.directory(directory))) {
            return false;
        }
        Path home = prepare(directory);
        DirectoryLock lock = DirectoryLock.acquire(home);
        try {
            DatabaseCluster cluster = new DatabaseCluster(home, PostgresBinaries.unpack(home), ProcessAccount.of(home));
            boolean runs = cluster.runs();
            if (runs) {
                cluster.stop();
            }
            return runs;
        } finally {
            lock.close();
        }
    }

    private static Path prepare(Path directory) {
        try {
            Path absolute = directory.toAbsolutePath().normalize();
            Files.createDirectories(absolute);
            // The database's own account must get through; what is secret in here has rights of its own.
            Files.setPosixFilePermissions(absolute, PosixFilePermissions.fromString("rwx--x--x"));
            return absolute.toRealPath();
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot use the data directory " + directory, e);
        }
    }

    public String jdbcUrl() {
        return "jdbc:postgresql://127.0.0.1:" + port + "/" + DATABASE;
    }

    public String user() {
        return USER;
    }

    public String password() {
        return password;
    }

    /** Loopback, TCP. */
    public int port() {
        return port;
    }

    /** True when it had outlived a killed server and was taken over. */
    public boolean wasAdopted() {
        return adopted;
    }

    /** Stops the database and frees the directory; call it after the last connection is closed. */
    @Override
    public synchronized void close() {
        if (closed) {
            return;
        }
        closed = true;
        guard.shutdown();
        try {
            cluster.stop();
        } finally {
            lock.close();
        }
    }

    private void keepAlive() {
        // The task lets nothing escape, so there is nothing to ask this future for.
        ScheduledFuture<?> unused = guard.scheduleWithFixedDelay(
                this::restartIfDead, GUARD_PERIOD.toMillis(), GUARD_PERIOD.toMillis(), TimeUnit.MILLISECONDS);
    }

    /** The kernel may kill a database when memory runs out; its port stays, so that the pool finds it again. */
    private synchronized void restartIfDead() {
        try {
            if (closed || cluster.runs()) {
                return;
            }
            LOG.warn("The database has died, starting it again");
            PostmasterFile.read(cluster.directory()).ifPresent(this::forgetStaleFile);
            cluster.restart(port);
        } catch (RuntimeException e) {
            LOG.error("The database could not be started again, trying once more soon: {}", e.getMessage(), e);
        }
    }

    private Optional<PostmasterFile> adopt() {
        Optional<PostmasterFile> left = PostmasterFile.read(cluster.directory());
        if (left.isEmpty()) {
            return Optional.empty();
        }
        Optional<ProcessHandle> process = left.get().process(cluster.directory());
        if (process.isEmpty()) {
            forgetStaleFile(left.get());
            return Optional.empty();
        }
        if (!cluster.isOfTheseProgramsOrUnknown(process.get())) {
            LOG.info(
                    "The database that outlived its server (process {}) is of another version, starting it anew",
                    process.get().pid());
            cluster.stop();
            return Optional.empty();
        }
        if (answers(left.get().port(), process.get())) {
            LOG.info(
                    "Took over the database that outlived its server (process {})",
                    process.get().pid());
            return left;
        }
        LOG.warn(
                "The database that outlived its server (process {}) does not answer, stopping it",
                process.get().pid());
        cluster.stop();
        return Optional.empty();
    }

    /** A process id may belong to another program by now; PostgreSQL itself would then refuse to start for ever. */
    private void forgetStaleFile(PostmasterFile file) {
        if (ProcessHandle.of(file.pid()).isEmpty()) {
            return;
        }
        LOG.info("Process {} is no longer the database, forgetting it", file.pid());
        try {
            Files.deleteIfExists(PostmasterFile.path(cluster.directory()));
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot clear what a killed database left", e);
        }
    }

    private boolean answers(int orphanPort, ProcessHandle process) {
        long deadline = System.nanoTime() + ADOPTION_LIMIT.toNanos();
        while (process.isAlive() && System.nanoTime() < deadline) {
            try (Connection connection = connect(orphanPort, "postgres");
                    Statement statement = connection.createStatement();
                    ResultSet result = statement.executeQuery("SHOW data_directory")) {
                return result.next() && cluster.directory().equals(Path.of(result.getString(1)));
            } catch (SQLException e) {
                LOG.debug("The database that outlived its server does not answer yet", e);
                PollDelay.of(BETWEEN_LOOKS);
            }
        }
        return false;
    }

    private void createDatabase() {
        try (Connection connection = connect(port, "postgres");
                Statement statement = connection.createStatement()) {
            boolean missing;
            try (ResultSet found =
                    statement.executeQuery("SELECT 1 FROM pg_database WHERE datname = '" + DATABASE + "'")) {
                missing = !found.next();
            }
            if (missing) {
                statement.execute("CREATE DATABASE " + DATABASE);
            }
        } catch (SQLException e) {
            cluster.stop();
            throw new StoreException("The server's own database started but refuses: " + e.getMessage(), e);
        }
    }

    private Connection connect(int toPort, String database) throws SQLException {
        Properties properties = new Properties();
        properties.setProperty("user", USER);
        properties.setProperty("password", password);
        properties.setProperty("connectTimeout", "5");
        properties.setProperty("socketTimeout", "30");
        return DriverManager.getConnection("jdbc:postgresql://127.0.0.1:" + toPort + "/" + database, properties);
    }
}
