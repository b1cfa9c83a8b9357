package org.dronemap.store.memory;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditQuery;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditedCallRecord;
import org.jspecify.annotations.Nullable;

/** Keeps the audit log in memory, for tests. Thread-safe: every method holds the object's lock. */
public final class MemoryAuditStore implements AuditStore {
    private final AuditChain chain;
    private final List<AuditRecord> records = new ArrayList<>();
    /** By the numbers of the records that they end: whoever reads all of them would look through all for each. */
    private final Map<Long, AuditRecord> endings = new HashMap<>();

    private final Map<String, AuditRecord> commands = new HashMap<>();

    public MemoryAuditStore(AuditChain chain) {
        this.chain = chain;
    }

    @Override
    public synchronized AuditRecord append(AuditEntry entry) {
        AuditEntry placed = entry;
        if (entry.endsItsCommand()) {
            Optional<AuditRecord> record = Optional.ofNullable(entry.command()).flatMap(this::ofCommand);
            Optional<AuditRecord> ended = record.flatMap(one -> Optional.ofNullable(endingOf(one)));
            if (ended.isPresent()) {
                return ended.get();
            }
            placed = entry.endingOf(record.map(AuditRecord::sequence).orElse(null));
        }
        AuditRecord next = chain.next(head(), placed);
        records.add(next);
        Long ends = placed.ends();
        String command = placed.command();
        if (ends != null) {
            endings.putIfAbsent(ends, next);
        } else if (command != null) {
            commands.putIfAbsent(command, next);
        }
        return next;
    }

    @Override
    public void appendLater(AuditEntry entry) {
        append(entry);
    }

    @Override
    public synchronized AuditHead head() {
        return records.isEmpty()
                ? AuditHead.EMPTY
                : records.get(records.size() - 1).head();
    }

    @Override
    public synchronized List<AuditRecord> after(long sequence, int limit) {
        return records.stream()
                .filter(record -> record.sequence() > sequence)
                .limit(limit)
                .toList();
    }

    @Override
    public synchronized List<AuditedCallRecord> search(AuditQuery query, long before, int limit) {
        List<AuditRecord> newestFirst = new ArrayList<>(records);
        Collections.reverse(newestFirst);
        return calls(newestFirst.stream())
                .filter(line -> line.record().sequence() < before)
                .filter(line -> fits(query, line))
                .limit(limit)
                .toList();
    }

    private Stream<AuditedCallRecord> calls(Stream<AuditRecord> of) {
        return of.filter(record -> record.entry().ends() == null)
                .map(record -> new AuditedCallRecord(record, endingOf(record)));
    }

    private @Nullable AuditRecord endingOf(AuditRecord call) {
        return endings.get(call.sequence());
    }

    private static boolean fits(AuditQuery query, AuditedCallRecord line) {
        AuditEntry entry = line.record().entry();
        String operation = query.operation();
        return isOr(query.user(), entry.by())
                && isOr(query.organisation(), entry.organisation())
                && isOr(query.drone(), entry.drone())
                && isOr(query.face(), entry.face())
                && isOr(query.outcome(), line.outcome())
                && (operation == null
                        || entry.operation().toLowerCase(Locale.ROOT).contains(operation.toLowerCase(Locale.ROOT)))
                && (query.from() == null || !entry.at().isBefore(query.from()))
                && (query.until() == null || entry.at().isBefore(query.until()));
    }

    private static boolean isOr(@Nullable Object wanted, @Nullable Object is) {
        return wanted == null || wanted.equals(is);
    }

    @Override
    public synchronized Optional<AuditRecord> ofCommand(String command) {
        return Optional.ofNullable(commands.get(command));
    }

    @Override
    public synchronized List<AuditRecord> underWay() {
        return calls(records.stream())
                .filter(line -> line.outcome() == AuditOutcome.UNDER_WAY)
                .map(AuditedCallRecord::record)
                .toList();
    }
}
