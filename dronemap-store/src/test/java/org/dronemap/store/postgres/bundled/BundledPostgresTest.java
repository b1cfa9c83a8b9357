package org.dronemap.store.postgres.bundled;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.awaitility.Awaitility;
import org.dronemap.core.command.CommandId;
import org.dronemap.store.StoreException;
import org.dronemap.store.postgres.PostgresStores;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BundledPostgresTest {
    /** The folder of a server that had run once and was stopped: most tests begin with a copy of it. */
    @TempDir
    private static Path stopped;

    @TempDir
    private Path directory;

    @BeforeAll
    static void runOnce() {
        TestDatabaseDirectories.putPrograms(stopped);
        PostgresStores.openOwn(stopped).close();
    }

    @AfterEach
    void leaveNoProcessBehind() {
        BundledPostgres.stopOrphan(directory);
    }

    @Test
    void takesOverTheDatabaseOfAKilledServer() throws Exception {
        TestDatabaseDirectories.copyStopped(stopped, directory);
        try (KilledDatabaseProcess child = new KilledDatabaseProcess(directory, "orphaned", 3)) {
            awaitDone(child);
            child.kill();
        }
        long orphan = postmaster().pid();
        try (BundledPostgres own = BundledPostgres.start(directory)) {
            assertThat(own.wasAdopted()).isTrue();
            assertThat(postmaster().pid()).isEqualTo(orphan);
            assertThat(count(own)).isEqualTo(3);
        }
        assertThat(PostmasterFile.read(DatabaseCluster.directory(directory.toRealPath())))
                .isEmpty();
    }

    @Test
    void startsADatabaseAnewThatProgramsOfAnotherVersionRun() throws Exception {
        TestDatabaseDirectories.copyStopped(stopped, directory);
        try (KilledDatabaseProcess child = new KilledDatabaseProcess(directory, "updated", 3)) {
            awaitDone(child);
            child.kill();
        }
        long orphan = postmaster().pid();
        Path programs = PostgresBinaries.unpack(directory.toRealPath()).directory();
        Files.move(programs, programs.resolveSibling("postgres-of-before"));
        TestDatabaseDirectories.putPrograms(directory);
        try (BundledPostgres own = BundledPostgres.start(directory)) {
            assertThat(own.wasAdopted()).isFalse();
            assertThat(postmaster().pid()).isNotEqualTo(orphan);
            assertThat(ProcessHandle.of(postmaster().pid()).orElseThrow().info().command())
                    .contains(programs.resolve("bin").resolve("postgres").toString());
            assertThat(count(own)).isEqualTo(3);
        }
    }

    @Test
    void recoversWhenServerAndDatabaseWereKilled() throws Exception {
        TestDatabaseDirectories.copyStopped(stopped, directory);
        try (KilledDatabaseProcess child = new KilledDatabaseProcess(directory, "crashed", 3)) {
            awaitDone(child);
            child.kill();
        }
        ProcessHandle postmaster = ProcessHandle.of(postmaster().pid()).orElseThrow();
        postmaster.destroyForcibly();
        postmaster.onExit().get();
        try (BundledPostgres own = BundledPostgres.start(directory)) {
            assertThat(own.wasAdopted()).isFalse();
            assertThat(count(own)).isEqualTo(3);
        }
    }

    @Test
    void losesNoAcknowledgedWriteOverRandomKills() throws Exception {
        TestDatabaseDirectories.copyStopped(stopped, directory);
        Random random = new Random(20260304);
        Set<String> acknowledged = new HashSet<>();
        int round = 0;
        while (acknowledged.size() < 120 || round < 3) {
            // The server alone in even rounds; in odd ones its database as well, in the middle of its work.
            acknowledged.addAll(killedAfter(20 + random.nextInt(80), round % 2 == 1, "round" + round));
            round++;
        }
        try (PostgresStores database = PostgresStores.openOwn(directory)) {
            assertThat(acknowledged)
                    .allMatch(
                            id -> database.commands().command(new CommandId(id)).isPresent());
            assertWaitsForTheDisk(database);
        }
    }

    /** Killing processes cannot show it, for the operating system keeps what they wrote: only a power cut would. */
    private static void assertWaitsForTheDisk(PostgresStores database) throws SQLException {
        for (String setting : List.of("fsync", "full_page_writes", "synchronous_commit")) {
            try (Connection connection = database.dataSource().getConnection();
                    Statement statement = connection.createStatement();
                    ResultSet result = statement.executeQuery("SHOW " + setting)) {
                assertThat(result.next()).isTrue();
                assertThat(result.getString(1)).as(setting).isEqualTo("on");
            }
        }
    }

    private Set<String> killedAfter(int writes, boolean databaseToo, String prefix)
            throws IOException, InterruptedException {
        Set<String> acknowledged = new HashSet<>();
        try (KilledDatabaseProcess child = new KilledDatabaseProcess(directory, prefix, 100_000)) {
            for (String line = child.line(); line != null; line = child.line()) {
                if (line.startsWith(prefix)) {
                    acknowledged.add(line);
                }
                if (acknowledged.size() == writes) {
                    if (databaseToo) {
                        ProcessHandle.of(postmaster().pid()).ifPresent(ProcessHandle::destroyForcibly);
                    }
                    child.kill();
                }
            }
        }
        return acknowledged;
    }

    @Test
    void startsADatabaseAgainThatDiesUnderARunningServer() throws Exception {
        TestDatabaseDirectories.copyStopped(stopped, directory);
        try (PostgresStores database = PostgresStores.openOwn(directory)) {
            database.commands().begin(KilledDatabaseWriter.command("before-the-death"));
            long first = postmaster().pid();
            ProcessHandle.of(first).orElseThrow().destroyForcibly();
            Awaitility.await()
                    .atMost(Duration.ofSeconds(60))
                    .ignoreExceptions()
                    .until(() ->
                            postmaster().pid() != first && database.health().isUp());
            assertThat(database.commands().command(new CommandId("before-the-death")))
                    .isPresent();
        }
    }

    @Test
    void refusesASecondServerOnTheSameDirectory() {
        TestDatabaseDirectories.copyStopped(stopped, directory);
        try (BundledPostgres first = BundledPostgres.start(directory)) {
            assertThatThrownBy(() -> BundledPostgres.start(directory))
                    .isInstanceOf(StoreException.class)
                    .hasMessageContaining("in use by another Dronemap server (process "
                            + ProcessHandle.current().pid() + ")");
            assertThat(first.port()).isPositive();
        }
    }

    @Test
    void keepsDataPasswordAndNothingRunningOverACleanRestart() throws Exception {
        TestDatabaseDirectories.copyStopped(stopped, directory);
        String password;
        try (BundledPostgres own = BundledPostgres.start(directory)) {
            password = own.password();
            execute(own, "CREATE TABLE kept AS SELECT 42 AS answer");
        }
        assertThat(PostmasterFile.read(DatabaseCluster.directory(directory.toRealPath())))
                .isEmpty();
        try (BundledPostgres own = BundledPostgres.start(directory)) {
            assertThat(own.wasAdopted()).isFalse();
            assertThat(own.password()).isEqualTo(password).hasSize(64);
            assertThat(number(own, "SELECT answer FROM kept")).isEqualTo(42);
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(directory.resolve("password"))))
                    .isEqualTo("rw-------");
            assertThatThrownBy(() -> DriverManager.getConnection(own.jdbcUrl(), own.user(), "guess"))
                    .isInstanceOf(SQLException.class)
                    .hasMessageContaining("password authentication failed");
        }
    }

    @Test
    void startsAfterACreationThatWasCutShortAndDespiteAForeignProcessId() throws Exception {
        TestDatabaseDirectories.putPrograms(directory);
        Path home = directory.toRealPath();
        Files.createDirectories(home.resolve("cluster.new").resolve("base"));
        Files.writeString(home.resolve("cluster.new").resolve("PG_VERSION"), "18\n");
        try (BundledPostgres own = BundledPostgres.start(directory)) {
            assertThat(own.wasAdopted()).isFalse();
        }
        // After a power cut the number in the file may belong to any program: here to this very test.
        Files.writeString(
                PostmasterFile.path(DatabaseCluster.directory(home)),
                ProcessHandle.current().pid() + "\n" + DatabaseCluster.directory(home)
                        + "\n1\n5432\n\n127.0.0.1\n1 1\nready\n");
        try (BundledPostgres own = BundledPostgres.start(directory)) {
            assertThat(own.wasAdopted()).isFalse();
            assertThat(number(own, "SELECT 1")).isEqualTo(1);
        }
    }

    @Test
    void refusesAClusterOfAnotherVersionWithWhatToDo() throws Exception {
        TestDatabaseDirectories.putPrograms(directory);
        Path cluster = Files.createDirectories(directory.resolve("cluster"));
        Files.writeString(cluster.resolve("PG_VERSION"), "9\n");
        assertThatThrownBy(() -> BundledPostgres.start(directory))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("was made by PostgreSQL 9")
                .hasMessageContaining("restore the backup");
    }

    @Test
    void refusesADirectoryThatIsAFile() throws Exception {
        Path file = Files.writeString(directory.resolve("file"), "x");
        assertThatThrownBy(() -> BundledPostgres.start(file))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("Cannot use the data directory");
    }

    @Test
    void namesTheProcessorThatItHasNoDatabaseFor() {
        assertThat(PostgresBinaries.archiveName("Linux", "amd64")).isEqualTo("postgres-linux-x86_64.txz");
        assertThat(PostgresBinaries.archiveName("Linux", "aarch64")).isEqualTo("postgres-linux-arm_64.txz");
        assertThat(PostgresBinaries.class.getResource("/postgres-linux-arm_64.txz"))
                .isNotNull();
        assertThatThrownBy(() -> PostgresBinaries.archiveName("Linux", "riscv64"))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("Linux on riscv64")
                .hasMessageContaining("DRONEMAP_DATABASE_URL");
    }

    private static void awaitDone(KilledDatabaseProcess child) throws IOException {
        String line = child.line();
        while (!"done".equals(line)) {
            assertThat(line).as("the child's output").isNotNull();
            line = child.line();
        }
    }

    private PostmasterFile postmaster() throws IOException {
        return PostmasterFile.read(DatabaseCluster.directory(directory.toRealPath()))
                .orElseThrow();
    }

    private static int count(BundledPostgres own) throws SQLException {
        return number(own, "SELECT count(*)::integer FROM dronemap.command");
    }

    private static int number(BundledPostgres own, String sql) throws SQLException {
        try (Connection connection = DriverManager.getConnection(own.jdbcUrl(), own.user(), own.password());
                Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery(sql)) {
            assertThat(result.next()).isTrue();
            return result.getInt(1);
        }
    }

    private static void execute(BundledPostgres own, String sql) throws SQLException {
        try (Connection connection = DriverManager.getConnection(own.jdbcUrl(), own.user(), own.password());
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }
}
