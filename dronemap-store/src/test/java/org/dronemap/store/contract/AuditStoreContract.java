package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditQuery;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditedCallRecord;
import org.dronemap.store.secret.HmacKeyedHash;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every store of audit records does. */
public abstract class AuditStoreContract {
    private static final Instant AT = Instant.parse("2026-03-04T05:06:07.123456Z");
    public static final AuditChain CHAIN = new AuditChain(new HmacKeyedHash(new byte[] {1, 2, 3}));

    protected AuditStore store;

    protected abstract AuditStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.head()).isEqualTo(AuditHead.EMPTY);
        assertThat(store.after(0, 10)).isEmpty();
        assertThat(store.search(AuditQuery.ALL, Long.MAX_VALUE, 10)).isEmpty();
        assertThat(store.underWay()).isEmpty();
    }

    @Test
    void chainsEachRecordToTheOneBefore() {
        List<AuditRecord> appended = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            appended.add(store.append(entry("alice", "op" + i, null, AuditOutcome.SUCCEEDED)));
        }
        assertThat(store.after(0, 10)).isEqualTo(appended);
        assertThat(store.after(2, 2)).isEqualTo(appended.subList(2, 4));
        assertThat(store.head()).isEqualTo(appended.get(4).head());
        AuditHead head = AuditHead.EMPTY;
        for (AuditRecord record : appended) {
            assertThat(record.sequence()).isEqualTo(head.sequence() + 1);
            assertThat(CHAIN.follows(head, record)).isTrue();
            head = record.head();
        }
    }

    @Test
    void givesBackEveryMemberAsItWas() {
        AuditEntry whole = new AuditEntry(
                AT,
                "alice",
                "rescue",
                "k1",
                "soap",
                "takeOff",
                "drone-1",
                17L,
                "command-1",
                "take off to 20 m — “ü🚁” \u0000\ud800",
                AuditOutcome.REFUSED,
                "gate: no",
                123L,
                null);
        AuditRecord record = store.append(whole);
        assertThat(store.after(0, 1)).containsExactly(record);
        assertThat(record.entry()).isEqualTo(whole);
        assertThat(record.entry().parameters()).isEqualTo("take off to 20 m — “ü🚁” \uFFFD\uFFFD");
        assertThat(store.ofCommand("command-1")).contains(record);
    }

    @Test
    void joinsACommandWithItsEnd() {
        AuditRecord open = store.append(entry("alice", "arm", "command-1", AuditOutcome.UNDER_WAY));
        assertThat(store.underWay()).containsExactly(open);

        AuditRecord end = store.append(open.entry().ending(AT.plusSeconds(2), AuditOutcome.FAILED, "no", 2_000L));

        assertThat(end.entry().ends()).isEqualTo(open.sequence());
        assertThat(store.underWay()).isEmpty();
        AuditedCallRecord line = only(AuditQuery.ALL);
        assertThat(line).isEqualTo(new AuditedCallRecord(open, end));
        assertThat(line.outcome()).isEqualTo(AuditOutcome.FAILED);
        assertThat(line.reason()).isEqualTo("no");
        assertThat(line.latencyMillis()).isEqualTo(2_000);
    }

    @Test
    void keepsOneEndOfACommandOnly() {
        AuditRecord open = store.append(entry("alice", "arm", "command-1", AuditOutcome.UNDER_WAY));
        AuditEntry ending = open.entry().ending(AT.plusSeconds(2), AuditOutcome.SUCCEEDED, null, 2_000L);
        AuditRecord first = store.append(ending);

        assertThat(store.append(ending)).isEqualTo(first);
        assertThat(store.head()).isEqualTo(first.head());
    }

    @Test
    void takesTheEndOfACommandWithoutRecordForItsRecord() {
        AuditEntry ending = entry("alice", "arm", "command-0", AuditOutcome.UNDER_WAY)
                .ending(AT, AuditOutcome.UNKNOWN, "restart", 5L);
        AuditRecord record = store.append(ending);
        assertThat(record.entry().ends()).isNull();
        assertThat(only(AuditQuery.ALL).outcome()).isEqualTo(AuditOutcome.UNKNOWN);
    }

    @Test
    void findsByEachOfWhatIsLookedFor() {
        store.append(entry("alice", "POST /api/v1/zones", null, AuditOutcome.SUCCEEDED));
        AuditRecord open = store.append(entry("bob", "takeOff", "command-1", AuditOutcome.UNDER_WAY));
        store.append(open.entry().ending(AT.plusSeconds(9), AuditOutcome.TIMED_OUT, "no answer", 9_000L));
        store.append(entry("carol", "arm", null, AuditOutcome.REFUSED));

        assertThat(found(new AuditQuery("bob", null, null, null, null, null, null, null)))
                .containsExactly(2L);
        assertThat(found(new AuditQuery(null, "of-carol", null, null, null, null, null, null)))
                .containsExactly(4L);
        assertThat(found(new AuditQuery(null, null, "drone-of-bob", null, null, null, null, null)))
                .containsExactly(2L);
        assertThat(found(new AuditQuery(null, null, null, "takeoff", null, null, null, null)))
                .containsExactly(2L);
        assertThat(found(new AuditQuery(null, null, null, "ZONE", null, null, null, null)))
                .containsExactly(1L);
        assertThat(found(new AuditQuery(null, null, null, null, "rest", null, null, null)))
                .containsExactly(4L, 2L, 1L);
        assertThat(found(new AuditQuery(null, null, null, null, null, AuditOutcome.TIMED_OUT, null, null)))
                .containsExactly(2L);
        assertThat(found(new AuditQuery(null, null, null, null, null, AuditOutcome.UNDER_WAY, null, null)))
                .isEmpty();
        assertThat(found(new AuditQuery(null, null, null, null, null, null, AT, AT.plusSeconds(1))))
                .hasSize(3);
        assertThat(found(new AuditQuery(null, null, null, null, null, null, AT.plusSeconds(1), null)))
                .isEmpty();
        assertThat(found(new AuditQuery(null, null, null, null, null, null, null, AT)))
                .isEmpty();
        assertThat(found(new AuditQuery("bob", null, null, "arm", null, null, null, null)))
                .isEmpty();
        assertThat(store.search(AuditQuery.ALL, 4, 1))
                .extracting(line -> line.record().sequence())
                .containsExactly(2L);
    }

    private AuditedCallRecord only(AuditQuery query) {
        List<AuditedCallRecord> lines = store.search(query, Long.MAX_VALUE, 10);
        assertThat(lines).hasSize(1);
        return lines.get(0);
    }

    private List<Long> found(AuditQuery query) {
        return store.search(query, Long.MAX_VALUE, 10).stream()
                .map(line -> line.record().sequence())
                .toList();
    }

    public static AuditEntry entry(String by, String operation, @Nullable String command, AuditOutcome outcome) {
        return new AuditEntry(
                AT,
                by,
                "of-" + by,
                null,
                "rest",
                operation,
                "drone-of-" + by,
                3L,
                command,
                "a=b",
                outcome,
                null,
                4L,
                null);
    }
}
