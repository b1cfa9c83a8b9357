package org.dronemap.core.audit;

import java.util.List;
import java.util.Optional;

/** Keeps signed heads outside of the database, one after the other; every write returns only after it is durable. */
public interface AuditHeadStore {
    /** Of each line in order: the head, or empty for a line that cannot be read. No list at all: nothing was ever kept. */
    Optional<List<Optional<SignedHead>>> all();

    void add(SignedHead head);
}
