package org.dronemap.core.operation;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.organisation.OrganisationId;

/** Stores operations and their journals; every write returns only after it is durable. */
public interface OperationStore {
    /** Those that have not ended, the oldest first. */
    List<SavedOperation> underWay();

    Optional<SavedOperation> find(OperationId id);

    /** Of one organisation and kind, the newest first. */
    List<SavedOperation> latest(OrganisationId organisation, String kind, int limit);

    /**
     * A new one with the first entry of its journal, both or neither.
     *
     * @throws RuntimeException when there is one of that id
     */
    void begin(SavedOperation operation, JournalEntry first);

    /**
     * The operation as it is now with the entry that made it so, both or neither.
     *
     * @throws RuntimeException when the entry does not follow the newest one that is kept, and then nothing is written
     */
    void append(SavedOperation now, JournalEntry entry);

    /** Entries from that number on, in order. */
    List<JournalEntry> journal(OperationId id, long from, int limit);

    /** Forgets one, journal and all; nothing when there is none. */
    void forget(OperationId id);

    /** Forgets those that ended before, journals and all; returns how many. */
    int forgetEndedBefore(Instant time);
}
