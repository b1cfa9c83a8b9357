package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.audit.AuditedCommandStore;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.store.StoreException;
import org.dronemap.store.contract.AuditStoreContract;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class PostgresAuditStoreTest extends AuditStoreContract {
    private static final Instant AT = Instant.parse("2026-03-04T05:06:07Z");
    private static final User ANN = new User("ann", Role.VIEWER, AccountState.ACTIVE, "x", false);

    private @Nullable PostgresStores opened;

    @Override
    protected AuditStore emptyStore() {
        return database().audit(CHAIN);
    }

    private PostgresStores database() {
        if (opened == null) {
            opened = SharedDatabase.another();
        }
        return opened;
    }

    @AfterEach
    void close() {
        database().close();
        opened = null;
    }

    @Test
    void writesAChangeAndItsRecordInOneTransaction() throws SQLException {
        AuditedCall call = call();
        call.during(() -> database().access().addUser(ANN));

        assertThat(store.after(0, 10)).hasSize(1);
        assertThat(number("SELECT count(DISTINCT xmin::text) FROM (SELECT xmin FROM account UNION ALL"
                        + " SELECT xmin FROM audit) AS written"))
                .isEqualTo(1);
    }

    @Test
    void changesNothingWhenTheRecordCannotBeWritten() throws SQLException {
        execute("ALTER TABLE audit ADD CONSTRAINT refuse_all CHECK (sequence < 0)");
        try {
            assertThatThrownBy(() -> call().during(() -> database().access().addUser(ANN)))
                    .isInstanceOf(StoreException.class);
            assertThat(database().access().user("ann")).isEmpty();
        } finally {
            execute("ALTER TABLE audit DROP CONSTRAINT refuse_all");
        }
        call().during(() -> database().access().addUser(ANN));
        assertThat(store.head().sequence()).isEqualTo(1);
    }

    @Test
    void leavesTheRecordToTheEndOfTheCallWhenNothingWasChanged() {
        AuditedCall call = call();
        call.during(() -> database().access().deleteUser("nobody"));
        assertThat(store.head()).isEqualTo(AuditHead.EMPTY);
        assertThat(call.claim()).isPresent();
    }

    @Test
    void leavesOneRecordForSeveralChangesOfACall() {
        AuditedCall call = call();
        call.during(() -> {
            database().access().addUser(ANN);
            database().access().updateUser(ANN.withState(AccountState.DISABLED));
            database().access().deleteOtherSignIns("ann", "");
            return ANN;
        });
        assertThat(store.after(0, 10)).hasSize(1);
        assertThat(call.claim()).isEmpty();
    }

    @Test
    void writesWhatIsBesideACallWithoutItsRecord() {
        AuditedCall call = call();
        call.during(() -> {
            AuditedCall.aside(() -> database().access().addUser(ANN));
            return ANN;
        });
        assertThat(store.head()).isEqualTo(AuditHead.EMPTY);
        assertThat(database().access().user("ann")).isPresent();
    }

    @Test
    void writesACommandItsEndAndTheirRecordsTogether() throws SQLException {
        CommandStore commands = new AuditedCommandStore(database().commands(), store, System::nanoTime);
        CommandRecord command = command("command-1");
        assertThat(commands.begin(command)).isTrue();
        assertThat(commands.begin(command)).isFalse();
        assertThat(number("SELECT count(DISTINCT xmin::text) FROM (SELECT xmin FROM command UNION ALL"
                        + " SELECT xmin FROM audit) AS written"))
                .isEqualTo(1);

        commands.finish(command.ended(new Outcome.Succeeded(), AT.plusMillis(1500)));
        commands.finish(command.ended(new Outcome.Succeeded(), AT.plusMillis(1500)));

        List<AuditRecord> records = store.after(0, 10);
        assertThat(records).hasSize(2);
        assertThat(records.get(0).entry().outcome()).isEqualTo(AuditOutcome.UNDER_WAY);
        assertThat(records.get(1).entry().ends()).isEqualTo(1);
        assertThat(records.get(1).entry().latencyMillis()).isEqualTo(1500);
    }

    @Test
    void endsWhatWasUnderWayWhenTheServerDied() {
        CommandStore commands = new AuditedCommandStore(database().commands(), store, System::nanoTime);
        commands.begin(command("command-1"));
        assertThat(commands.endUnfinished(new Outcome.Unknown("restart"), AT.plusSeconds(1)))
                .isEqualTo(1);
        assertThat(commands.endUnfinished(new Outcome.Unknown("restart"), AT.plusSeconds(2)))
                .isZero();
        assertThat(store.after(1, 10))
                .extracting(record -> record.entry().outcome())
                .containsExactly(AuditOutcome.UNKNOWN);
    }

    @Test
    void chainsWhatManyWriteAtOnce() {
        CommandStore commands = new AuditedCommandStore(database().commands(), store, System::nanoTime);
        ExecutorService threads = Executors.newFixedThreadPool(16);
        try {
            List<CompletableFuture<Boolean>> begun = new ArrayList<>();
            for (int i = 0; i < 400; i++) {
                CommandRecord command = command("command-" + i % 300);
                begun.add(CompletableFuture.supplyAsync(() -> commands.begin(command), threads));
            }
            assertThat(begun.stream().filter(CompletableFuture::join)).hasSize(300);
        } finally {
            threads.shutdown();
        }
        AuditHead head = AuditHead.EMPTY;
        for (AuditRecord record : store.after(0, 1_000)) {
            assertThat(CHAIN.follows(head, record)).isTrue();
            head = record.head();
        }
        assertThat(head.sequence()).isEqualTo(300);
        assertThat(head).isEqualTo(store.head());
    }

    @Test
    void goesOnWhereItWas() {
        store.append(entry("alice", "arm", null, AuditOutcome.SUCCEEDED));
        AuditHead head = store.head();
        database().close();
        opened = SharedDatabase.again();
        store = opened.audit(CHAIN);
        AuditRecord next = store.append(entry("alice", "disarm", null, AuditOutcome.SUCCEEDED));
        assertThat(next.sequence()).isEqualTo(2);
        assertThat(CHAIN.follows(head, next)).isTrue();
    }

    private static AuditedCall call() {
        return new AuditedCall(entry("alice", "POST /api/v1/users", null, AuditOutcome.SUCCEEDED), System::nanoTime);
    }

    private static CommandRecord command(String id) {
        return new CommandRecord(
                new CommandId(id),
                new DroneId("copter-1"),
                "alice",
                "rest",
                "Arm",
                "arm",
                AT,
                CommandPhase.SENT,
                null,
                null,
                null,
                7L);
    }

    private void execute(String sql) throws SQLException {
        try (Connection connection = database().dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    private long number(String sql) throws SQLException {
        try (Connection connection = database().dataSource().getConnection();
                Statement statement = connection.createStatement();
                java.sql.ResultSet result = statement.executeQuery(sql)) {
            result.next();
            return result.getLong(1);
        }
    }
}
