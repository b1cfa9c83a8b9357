package org.dronemap.store.memory;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.store.StoreException;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;

/**
 * Keeps operations (mission runs and follows) and their journals in memory, for tests. Thread-safe: every method holds
 * the object's lock.
 */
public final class MemoryOperationStore implements OperationStore {
    private static final Comparator<SavedOperation> BY_ID =
            Comparator.comparing(operation -> operation.id().value());

    private final Map<OperationId, SavedOperation> operations = new HashMap<>();
    private final Map<OperationId, List<JournalEntry>> journals = new HashMap<>();

    @Override
    public synchronized List<SavedOperation> underWay() {
        return operations.values().stream()
                .filter(operation -> operation.endedAt() == null)
                .sorted(Comparator.comparing(SavedOperation::beganAt).thenComparing(BY_ID))
                .toList();
    }

    @Override
    public synchronized Optional<SavedOperation> find(OperationId id) {
        return Optional.ofNullable(operations.get(id));
    }

    @Override
    public synchronized List<SavedOperation> latest(OrganisationId organisation, String kind, int limit) {
        return operations.values().stream()
                .filter(operation -> operation.organisation().equals(organisation)
                        && operation.kind().equals(kind))
                .sorted(Comparator.comparing(SavedOperation::beganAt).reversed().thenComparing(BY_ID))
                .limit(limit)
                .toList();
    }

    @Override
    public synchronized void begin(SavedOperation operation, JournalEntry first) {
        if (operations.containsKey(operation.id())) {
            throw new StoreException("There is an operation " + operation.id() + " already.");
        }
        operations.put(operation.id(), stored(operation));
        journals.put(operation.id(), new ArrayList<>(List.of(stored(first))));
    }

    @Override
    public synchronized void append(SavedOperation now, JournalEntry entry) {
        SavedOperation before = operations.get(now.id());
        List<JournalEntry> journal = journals.get(now.id());
        if (before == null || journal == null || before.last() != entry.number() - 1) {
            throw new StoreException("The entry " + entry.number() + " does not follow what is kept of " + now.id());
        }
        operations.put(now.id(), stored(now));
        journal.add(stored(entry));
    }

    @Override
    public synchronized List<JournalEntry> journal(OperationId id, long from, int limit) {
        return journals.getOrDefault(id, List.of()).stream()
                .filter(entry -> entry.number() >= from)
                .limit(limit)
                .toList();
    }

    @Override
    public synchronized void forget(OperationId id) {
        operations.remove(id);
        journals.remove(id);
    }

    @Override
    public synchronized int forgetEndedBefore(Instant time) {
        List<OperationId> old = operations.values().stream()
                .filter(operation ->
                        operation.endedAt() != null && operation.endedAt().isBefore(time))
                .map(SavedOperation::id)
                .toList();
        old.forEach(this::forget);
        return old.size();
    }

    private static JournalEntry stored(JournalEntry entry) {
        return new JournalEntry(entry.number(), StoredInstant.of(entry.at()), entry.input(), entry.decision());
    }

    private static SavedOperation stored(SavedOperation operation) {
        return new SavedOperation(
                operation.id(),
                operation.kind(),
                operation.owner(),
                operation.account(),
                operation.organisation(),
                operation.name(),
                StoredInstant.of(operation.beganAt()),
                end(operation.endedAt()),
                operation.last(),
                operation.given(),
                operation.state());
    }

    private static @Nullable Instant end(@Nullable Instant at) {
        return at == null ? null : StoredInstant.of(at);
    }
}
