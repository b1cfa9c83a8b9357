package org.dronemap.core.conduct;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;

/** Fails when a test says so, before or after it has written. */
final class FailingOperationStore implements OperationStore {
    final Map<OperationId, SavedOperation> operations = new LinkedHashMap<>();
    final List<JournalEntry> journal = new ArrayList<>();
    volatile boolean away;
    /** The next write is written, and seems to fail. */
    volatile boolean deceiving;

    private void answer() {
        if (away) {
            throw new IllegalStateException("the disk is full");
        }
    }

    private void deceive() {
        if (deceiving) {
            deceiving = false;
            throw new IllegalStateException("the connection broke");
        }
    }

    @Override
    public synchronized List<SavedOperation> underWay() {
        answer();
        return operations.values().stream().filter(one -> one.endedAt() == null).toList();
    }

    @Override
    public synchronized Optional<SavedOperation> find(OperationId id) {
        answer();
        return Optional.ofNullable(operations.get(id));
    }

    @Override
    public synchronized List<SavedOperation> latest(OrganisationId organisation, String kind, int limit) {
        return operations.values().stream()
                .filter(operation -> operation.kind().equals(kind))
                .toList();
    }

    @Override
    public synchronized void begin(SavedOperation operation, JournalEntry first) {
        answer();
        operations.put(operation.id(), operation);
        journal.add(first);
        deceive();
    }

    @Override
    public synchronized void append(SavedOperation now, JournalEntry entry) {
        answer();
        SavedOperation before = operations.get(now.id());
        if (before == null || before.last() != entry.number() - 1) {
            throw new IllegalStateException("does not follow");
        }
        operations.put(now.id(), now);
        journal.add(entry);
        deceive();
    }

    @Override
    public synchronized List<JournalEntry> journal(OperationId id, long from, int limit) {
        return journal.stream()
                .filter(entry -> entry.number() >= from)
                .limit(limit)
                .toList();
    }

    @Override
    public synchronized void forget(OperationId id) {
        answer();
        operations.remove(id);
    }

    @Override
    public synchronized int forgetEndedBefore(Instant time) {
        return 0;
    }
}
