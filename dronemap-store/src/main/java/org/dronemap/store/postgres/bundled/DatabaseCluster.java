package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.function.IntSupplier;
import org.dronemap.store.StoreException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The files of the bundled PostgreSQL, and the tools that create, start and stop it. Not thread-safe; its owner
 * serializes.
 */
final class DatabaseCluster {
    private static final Logger LOG = LoggerFactory.getLogger(DatabaseCluster.class);
    private static final Duration INITDB_LIMIT = Duration.ofMinutes(3);

    /** Recovery of a crashed database replays at most max_wal_size, yet a slow disk may take its time. */
    private static final int START_LIMIT_SECONDS = 180;

    /** Some seconds in all; what stands in the way is mostly gone after the first pause. */
    private static final int START_ATTEMPTS = 25;

    private static final Duration BETWEEN_ATTEMPTS = Duration.ofMillis(100);
    private static final int STOP_LIMIT_SECONDS = 60;
    private static final String SETTINGS_FILE = "dronemap.conf";

    /** Small, since the whole product runs in 4 GB; durable, since a write that was acknowledged must not be lost. */
    private static final String SETTINGS = """
            # Written by Dronemap at each start; changes here are lost.
            listen_addresses = '127.0.0.1'
            unix_socket_directories = ''
            port = {port}
            max_connections = 30
            shared_buffers = '32MB'
            work_mem = '4MB'
            maintenance_work_mem = '32MB'
            max_wal_size = '256MB'
            min_wal_size = '80MB'
            max_parallel_workers = 0
            max_parallel_workers_per_gather = 0
            max_parallel_maintenance_workers = 0
            max_worker_processes = 4
            max_wal_senders = 0
            wal_level = minimal
            io_method = sync
            autovacuum_max_workers = 1
            jit = off
            fsync = on
            synchronous_commit = on
            full_page_writes = on
            timezone = 'UTC'
            log_timezone = 'UTC'
            logging_collector = on
            log_directory = 'log'
            log_filename = 'postgres-%a.log'
            log_truncate_on_rotation = on
            log_rotation_age = 1d
            log_rotation_size = 0
            """;

    private final Path home;
    private final Path directory;
    private final PostgresBinaries engine;
    private final ProcessAccount runAs;

    DatabaseCluster(Path home, PostgresBinaries engine, ProcessAccount runAs) {
        this.home = home;
        this.directory = directory(home);
        this.engine = engine;
        this.runAs = runAs;
    }

    static Path directory(Path home) {
        return home.resolve("cluster");
    }

    Path directory() {
        return directory;
    }

    /** Creates the files if there are none; an interrupted creation is thrown away. */
    void createIfMissing(String superuser, String password) {
        try {
            if (Files.exists(directory.resolve("PG_VERSION"))) {
                requireSameVersion();
                runAs.own(directory);
                return;
            }
            PostgresBinaries.requireSpace(home);
            Path fresh = home.resolve("cluster.new");
            FileTree.delete(fresh);
            Files.createDirectory(
                    fresh, PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
            runAs.own(fresh);
            initialize(fresh, superuser, password);
            Files.writeString(
                    fresh.resolve("postgresql.conf"),
                    "\ninclude_if_exists = '" + SETTINGS_FILE + "'\n",
                    StandardOpenOption.APPEND);
            Files.move(fresh, directory, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot create the database in " + directory, e);
        }
    }

    private void initialize(Path fresh, String superuser, String password) throws IOException {
        LOG.info("Creating the database in {}", directory);
        Path passwordFile = Files.createTempFile(home, "initial", ".password");
        try {
            Files.writeString(passwordFile, password);
            runAs.own(passwordFile);
            ToolResult run = run(
                    INITDB_LIMIT,
                    engine.program("initdb").toString(),
                    "--pgdata=" + fresh,
                    "--username=" + superuser,
                    "--pwfile=" + passwordFile,
                    "--auth=scram-sha-256",
                    "--encoding=UTF8",
                    "--locale=C",
                    "--data-checksums",
                    "--no-instructions");
            if (!run.succeeded()) {
                throw new StoreException(
                        "Cannot create the database in " + directory + ": " + FileErrorMessages.advice(run.output()));
            }
        } finally {
            Files.deleteIfExists(passwordFile);
        }
    }

    private void requireSameVersion() throws IOException {
        String made = Files.readString(directory.resolve("PG_VERSION")).strip();
        ToolResult run = run(Duration.ofSeconds(30), engine.program("postgres").toString(), "--version");
        if (!run.succeeded()) {
            throw new StoreException("PostgreSQL does not run on this machine: " + run.output());
        }
        String brought = run.output().replaceFirst(".*\\) ", "");
        if (!brought.startsWith(made + ".")) {
            throw new StoreException("The database in " + directory + " was made by PostgreSQL " + made
                    + ", and this Dronemap brings " + brought + "; make a backup with the Dronemap that made it, "
                    + "move the directory away and restore the backup.");
        }
    }

    /** False when it is known that other programs than these run it, such as those of an older Dronemap. */
    boolean isOfTheseProgramsOrUnknown(ProcessHandle process) {
        Path program = engine.program("postgres");
        return process.info().command().map(Path::of).map(program::equals).orElse(true);
    }

    /** Starts it on a free loopback port and returns that once it takes connections. */
    int start() {
        return start(DatabaseCluster::freePort);
    }

    /** Starts it again on the port that others know. */
    void restart(int port) {
        start(() -> port);
    }

    private int start(IntSupplier ports) {
        for (int attempt = 1; ; attempt++) {
            int port = ports.getAsInt();
            ToolResult run = start(port);
            if (run.succeeded()) {
                return port;
            }
            String log = startLog();
            // A port is free only until somebody takes it; processes of a killed database need a moment to be gone.
            boolean passes = log.contains("Address already in use") || log.contains("is still in use");
            if (attempt == START_ATTEMPTS || !passes) {
                throw new StoreException("The database in " + directory + " does not start: "
                        + FileErrorMessages.advice(log.isBlank() ? run.output() : log));
            }
            LOG.info("The database does not start yet, trying again: {}", log);
            PollDelay.of(BETWEEN_ATTEMPTS);
        }
    }

    private ToolResult start(int port) {
        try {
            Files.writeString(directory.resolve(SETTINGS_FILE), SETTINGS.replace("{port}", Integer.toString(port)));
            Path log = startLogFile();
            Files.writeString(log, "");
            runAs.own(directory.resolve(SETTINGS_FILE));
            runAs.own(log);
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot write the database's settings in " + directory, e);
        }
        return run(
                Duration.ofSeconds(START_LIMIT_SECONDS + 10),
                engine.program("pg_ctl").toString(),
                "start",
                "--pgdata=" + directory,
                "--log=" + startLogFile(),
                "--wait",
                "--timeout=" + START_LIMIT_SECONDS);
    }

    /** Ends connections and stops; when that does not end in time, stops the hard way (the next start recovers). */
    void stop() {
        ToolResult fast = stop("fast");
        if (!fast.succeeded() && runs()) {
            LOG.warn("The database does not stop in {} s, stopping it at once: {}", STOP_LIMIT_SECONDS, fast.output());
            ToolResult immediate = stop("immediate");
            if (!immediate.succeeded() && runs()) {
                throw new StoreException("The database in " + directory + " cannot be stopped: " + immediate.output());
            }
        }
    }

    boolean runs() {
        return PostmasterFile.read(directory)
                .flatMap(file -> file.process(directory))
                .isPresent();
    }

    private ToolResult stop(String mode) {
        return run(
                Duration.ofSeconds(STOP_LIMIT_SECONDS + 10),
                engine.program("pg_ctl").toString(),
                "stop",
                "--pgdata=" + directory,
                "--mode=" + mode,
                "--wait",
                "--timeout=" + STOP_LIMIT_SECONDS);
    }

    private ToolResult run(Duration limit, String... command) {
        return ToolResult.of(runAs.wrap(List.of(command)), engine.directory(), limit);
    }

    private Path startLogFile() {
        return directory.resolve("start.log");
    }

    private String startLog() {
        try {
            return Files.readString(startLogFile(), StandardCharsets.ISO_8859_1).strip();
        } catch (IOException e) {
            return "its log cannot be read: " + e.getMessage();
        }
    }

    private static int freePort() {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByAddress(new byte[] {127, 0, 0, 1}))) {
            return socket.getLocalPort();
        } catch (IOException e) {
            throw new StoreException("No free port on 127.0.0.1 for the database: " + e.getMessage(), e);
        }
    }
}
