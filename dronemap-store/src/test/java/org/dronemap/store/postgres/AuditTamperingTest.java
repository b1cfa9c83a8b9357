package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditHeadWriter;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.core.audit.AuditVerifier;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.core.time.RealTime;
import org.dronemap.store.file.FileAuditHeadStore;
import org.dronemap.store.secret.HmacKeyedHash;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whoever can write to the database, and even to the files beside it, cannot change what was done without being seen. */
class AuditTamperingTest {
    private static final Instant AT = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final AuditChain CHAIN = new AuditChain(new HmacKeyedHash(new byte[] {7, 7, 7}));
    private static final int RECORDS = 8;
    /** Columns whose text can be changed byte by byte; the others hold numbers and times. */
    private static final List<String> TEXTS = List.of(
            "account_name",
            "organisation_id",
            "access_key",
            "face",
            "operation",
            "drone_id",
            "command_id",
            "parameters",
            "outcome",
            "reason",
            "hash");

    private static final Map<String, String> OTHERS = Map.of(
            "happened_at", "happened_at + interval '1 microsecond'",
            "epoch", "epoch + 1",
            "latency_millis", "latency_millis # 64",
            "ends", "coalesce(ends, 0) + 100",
            "sequence", "sequence + 100");

    @TempDir
    private Path directory;

    private PostgresStores database;
    private AuditStore store;
    private FileAuditHeadStore heads;
    private AuditHeadWriter keeper;
    private SignedAuditHead receipt;

    @BeforeEach
    void fill() {
        database = SharedDatabase.another();
        store = database.audit(CHAIN);
        heads = new FileAuditHeadStore(directory.resolve("audit-heads"));
        keeper = new AuditHeadWriter(store, heads, CHAIN, new RealTime());
        keeper.start();
        for (int i = 1; i <= RECORDS; i++) {
            store.append(entry(i));
            if (i == RECORDS - 2) {
                receipt = keeper.receipt();
            }
        }
        assertThat(verify(receipt)).isEqualTo(new AuditVerdict(store.head(), null, null));
    }

    private static AuditEntry entry(int i) {
        return new AuditEntry(
                AT.plusSeconds(i),
                "alice",
                "organisation-" + i,
                "k" + i,
                "rest",
                "takeOff",
                "drone-" + i,
                (long) i,
                "command-" + i,
                "take off to 20 m ü",
                AuditOutcome.FAILED,
                "vehicle: no",
                12L,
                null);
    }

    @AfterEach
    void close() {
        keeper.close();
        database.close();
    }

    @Test
    void findsEveryChangedByteOfEveryText() throws SQLException {
        int changes = 0;
        for (String column : TEXTS) {
            byte[] before = bytes(column, 4);
            for (int place = 0; place < before.length; place++) {
                for (int bit : new int[] {1, 32}) {
                    byte[] after = before.clone();
                    after[place] ^= (byte) bit;
                    if (isText(after)) {
                        set(column, 4, after);
                        assertThat(verify(null).firstBad())
                                .as(column + " byte " + place)
                                .isEqualTo(4);
                        changes++;
                    }
                }
            }
            set(column, 4, before);
        }
        assertThat(changes).isGreaterThan(200);
        assertThat(verify(receipt).isSound()).isTrue();
    }

    @Test
    void findsWhatIsAddedCutOrTakenOut() throws SQLException {
        for (String column : TEXTS) {
            byte[] before = bytes(column, 4);
            String text = new String(before, StandardCharsets.UTF_8);
            for (String after : List.of(text + " ", text + "x".repeat(600), text.substring(1), "")) {
                set(column, 4, after.getBytes(StandardCharsets.UTF_8));
                assertThat(verify(null).firstBad()).as(column + ": " + after).isEqualTo(4);
            }
            set(column, 4, before);
        }
        for (String column :
                List.of("account_name", "organisation_id", "access_key", "drone_id", "command_id", "reason")) {
            byte[] before = bytes(column, 4);
            execute("UPDATE audit SET " + column + " = NULL WHERE sequence = 4");
            assertThat(verify(null).firstBad()).as(column + " is null").isEqualTo(4);
            set(column, 4, before);
        }
        assertThat(verify(receipt).isSound()).isTrue();
    }

    @Test
    void findsEveryChangedNumberAndTime() throws SQLException {
        for (Map.Entry<String, String> change : OTHERS.entrySet()) {
            execute("CREATE TABLE kept AS SELECT * FROM audit WHERE sequence = 4");
            execute("UPDATE audit SET " + change.getKey() + " = " + change.getValue() + " WHERE sequence = 4");
            assertThat(verify(null).firstBad()).as(change.getKey()).isEqualTo(4);
            execute("DELETE FROM audit WHERE sequence IN (4, 104)");
            execute("INSERT INTO audit SELECT * FROM kept");
            execute("DROP TABLE kept");
        }
        assertThat(verify(receipt).isSound()).isTrue();
    }

    @Test
    void findsRecordsThatAreGone() throws SQLException {
        for (int gone = 1; gone < RECORDS; gone++) {
            execute("CREATE TABLE kept AS SELECT * FROM audit WHERE sequence = " + gone);
            execute("DELETE FROM audit WHERE sequence = " + gone);
            assertThat(verify(null).firstBad()).isEqualTo(gone);
            // Also when the rest moves up.
            execute("UPDATE audit SET sequence = sequence - 1001 + 1000 WHERE sequence > " + gone);
            assertThat(verify(null).firstBad()).isEqualTo(gone);
            execute("UPDATE audit SET sequence = sequence + 1000 WHERE sequence >= " + gone);
            execute("UPDATE audit SET sequence = sequence - 999 WHERE sequence > 1000");
            execute("INSERT INTO audit SELECT * FROM kept");
            execute("DROP TABLE kept");
        }
        assertThat(verify(receipt).isSound()).isTrue();
    }

    @Test
    void findsThatTheTailIsGoneByWhatIsKeptBesideTheDatabase() throws SQLException {
        keeper.receipt();
        execute("DELETE FROM audit WHERE sequence = " + RECORDS);
        assertThat(verify(null).firstBad()).isEqualTo(RECORDS);
    }

    @Test
    void findsThatTheTailIsGoneByAReceiptAlone() throws IOException, SQLException {
        Files.delete(directory.resolve("audit-heads"));
        heads.add(CHAIN.sign(SignedAuditHead.Kind.BEGUN, AuditHead.EMPTY, AT));
        execute("DELETE FROM audit WHERE sequence >= " + (RECORDS - 2));
        assertThat(verify(null).isSound()).isTrue();
        assertThat(verify(receipt).firstBad()).isEqualTo(RECORDS - 2);
        assertThat(verify(receipt).why()).contains("the receipt of");
        execute("DELETE FROM audit");
        assertThat(verify(receipt).firstBad()).isEqualTo(1);
    }

    @Test
    void findsRecordsInAnotherOrder() throws SQLException {
        for (int first = 1; first < RECORDS; first++) {
            for (int second = first + 1; second <= RECORDS; second++) {
                swap(first, second);
                assertThat(verify(null).firstBad()).isEqualTo(first);
                swap(first, second);
            }
        }
        assertThat(verify(receipt).isSound()).isTrue();
    }

    @Test
    void findsAChainMadeAnewWithAnotherKey() throws SQLException {
        remake(new AuditChain(new HmacKeyedHash(new byte[] {1})));
        assertThat(verify(null).firstBad()).isEqualTo(1);
    }

    @Test
    void findsAChainMadeAnewWithTheRightKeyByWhatWasKept() throws SQLException {
        remake(CHAIN);
        assertThat(verify(null).firstBad()).isEqualTo(RECORDS - 2);
        assertThat(verify(null).why()).contains("the chain was made anew");
    }

    @Test
    void findsAChainMadeAnewWithTheRightKeyAndAllFilesByAReceipt() throws IOException, SQLException {
        remake(CHAIN);
        Files.delete(directory.resolve("audit-heads"));
        heads.add(CHAIN.sign(SignedAuditHead.Kind.BEGUN, AuditHead.EMPTY, AT));
        assertThat(verify(null).isSound()).isTrue();
        assertThat(verify(receipt).firstBad()).isEqualTo(RECORDS - 2);
    }

    @Test
    void findsChangedAndMissingHeads() throws IOException {
        Path file = directory.resolve("audit-heads");
        byte[] before = Files.readAllBytes(file);
        for (int place = 0; place < before.length; place++) {
            byte[] after = before.clone();
            after[place] ^= 1;
            Files.write(file, after);
            assertThat(verify(null).isSound()).as("byte " + place).isFalse();
        }
        Files.delete(file);
        assertThat(verify(null).why()).contains("is gone");
        keeper.start();
        assertThat(verify(null).why()).contains("begins only at record " + RECORDS);
    }

    @Test
    void takesNoReceiptButItsOwn() {
        SignedAuditHead foreign = new AuditChain(new HmacKeyedHash(new byte[] {9}))
                .sign(SignedAuditHead.Kind.ANCHORED, receipt.head(), receipt.at());
        assertThat(verify(foreign).why()).contains("not one of this server");
    }

    @Test
    void acceptsWhatARestoreTookBackAndStillKnowsReceiptsOfWhatIsGone() throws SQLException {
        SignedAuditHead last = keeper.receipt();
        execute("DELETE FROM audit WHERE sequence > " + (RECORDS - 1));
        database.close();
        database = SharedDatabase.again();
        store = database.audit(CHAIN);
        keeper.close();
        keeper = new AuditHeadWriter(store, heads, CHAIN, new RealTime());
        keeper.restored();
        store.append(entry(50));
        store.append(entry(51));

        assertThat(verify(null).isSound()).isTrue();
        assertThat(verify(receipt).isSound()).isTrue();
        assertThat(verify(last).why()).contains("was restored at");
    }

    private AuditVerdict verify(@Nullable SignedAuditHead with) {
        return new AuditVerifier(store, heads, CHAIN).verify(with);
    }

    private void remake(AuditChain chain) throws SQLException {
        List<AuditRecord> records = new ArrayList<>(store.after(0, 100));
        AuditHead head = AuditHead.EMPTY;
        for (AuditRecord old : records) {
            AuditEntry entry = old.sequence() == 2 ? entry(99) : old.entry();
            AuditRecord anew = chain.next(head, entry);
            head = anew.head();
            execute("DELETE FROM audit WHERE sequence = " + old.sequence());
            try (Connection connection = database.dataSource().getConnection()) {
                AuditRows.insert(connection, anew);
            }
        }
    }

    private void swap(int first, int second) throws SQLException {
        execute("UPDATE audit SET sequence = -1 WHERE sequence = " + first);
        execute("UPDATE audit SET sequence = " + first + " WHERE sequence = " + second);
        execute("UPDATE audit SET sequence = " + second + " WHERE sequence = -1");
    }

    /** What PostgreSQL's text can hold. */
    private static boolean isText(byte[] bytes) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        return !text.contains("\uFFFD") && text.indexOf(0) < 0;
    }

    private byte[] bytes(String column, int sequence) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement();
                ResultSet result =
                        statement.executeQuery("SELECT " + column + " FROM audit WHERE sequence = " + sequence)) {
            result.next();
            return result.getString(1).getBytes(StandardCharsets.UTF_8);
        }
    }

    private void set(String column, int sequence, byte[] text) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                PreparedStatement statement =
                        connection.prepareStatement("UPDATE audit SET " + column + " = ? WHERE sequence = ?")) {
            statement.setString(1, new String(text, StandardCharsets.UTF_8));
            statement.setInt(2, sequence);
            assertThat(statement.executeUpdate()).isEqualTo(1);
        }
    }

    private void execute(String sql) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }
}
