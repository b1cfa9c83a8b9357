package org.dronemap.store.postgres;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditQuery;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditedCallRecord;

/** Stores the audit log in PostgreSQL. Thread-safe. */
final class PostgresAuditStore implements AuditStore {
    private final SqlTransactions sql;
    private final AuditLedger ledger;

    PostgresAuditStore(SqlTransactions sql, AuditLedger ledger) {
        this.sql = sql;
        this.ledger = ledger;
    }

    @Override
    public AuditRecord append(AuditEntry entry) {
        return ledger.append(entry);
    }

    @Override
    public void appendLater(AuditEntry entry) {
        ledger.appendLater(entry);
    }

    @Override
    public AuditHead head() {
        return ledger.head();
    }

    @Override
    public List<AuditRecord> after(long sequence, int limit) {
        return sql.list(
                "SELECT * FROM audit WHERE sequence > ? ORDER BY sequence LIMIT ?", AuditRows::record, sequence, limit);
    }

    @Override
    public List<AuditedCallRecord> search(AuditQuery query, long before, int limit) {
        AuditSearchConditions conditions = new AuditSearchConditions(query, before);
        List<AuditRecord> calls = sql.list(
                "SELECT r.* FROM audit r LEFT JOIN audit e ON e.ends = r.sequence WHERE " + conditions.text()
                        + " ORDER BY r.sequence DESC LIMIT " + limit,
                AuditRows::record,
                conditions.arguments());
        Map<Long, AuditRecord> endings = endings(calls);
        return calls.stream()
                .map(call -> new AuditedCallRecord(call, endings.get(call.sequence())))
                .toList();
    }

    private Map<Long, AuditRecord> endings(List<AuditRecord> of) {
        Long[] sequences = of.stream().map(AuditRecord::sequence).toArray(Long[]::new);
        return sql.list("SELECT * FROM audit WHERE ends = ANY(?)", AuditRows::record, new Object[] {sequences}).stream()
                .collect(Collectors.toMap(
                        ending -> Optional.ofNullable(ending.entry().ends()).orElse(0L), Function.identity()));
    }

    @Override
    public Optional<AuditRecord> ofCommand(String command) {
        return sql.one(
                "SELECT * FROM audit WHERE command_id = ? AND ends IS NULL ORDER BY sequence LIMIT 1",
                AuditRows::record,
                command);
    }

    @Override
    public List<AuditRecord> underWay() {
        return sql.list(
                "SELECT r.* FROM audit r WHERE r.outcome = 'UNDER_WAY' AND NOT EXISTS"
                        + " (SELECT 1 FROM audit e WHERE e.ends = r.sequence) ORDER BY r.sequence",
                AuditRows::record);
    }
}
