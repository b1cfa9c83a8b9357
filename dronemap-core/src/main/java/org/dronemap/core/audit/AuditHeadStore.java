package org.dronemap.core.audit;

import java.util.List;
import java.util.Optional;

/** Stores signed heads of the audit chain in order, outside the database; writes return only once durable. */
public interface AuditHeadStore {
    /** Of each line in order: the head, or empty for a line that cannot be read. No list at all: nothing was ever kept. */
    Optional<List<Optional<SignedAuditHead>>> all();

    void add(SignedAuditHead head);
}
