package org.dronemap.core.audit;

import java.util.List;
import java.util.Optional;

/**
 * Stores the chained audit records. Where the changes themselves are kept in the same place, they and their records
 * become durable together ({@link AuditedCall}).
 */
public interface AuditStore {
    /** Returns when it is durable. An ending of a command finds the command's record by itself. */
    AuditRecord append(AuditEntry entry);

    /** The same without waiting: kept and tried again while the store is out of reach, for as long as there is room. */
    void appendLater(AuditEntry entry);

    AuditHead head();

    /** In order, at most so many, of those after that number. */
    List<AuditRecord> after(long sequence, int limit);

    /** Calls with their ends, newest first, at most so many, of those before that number. */
    List<AuditedCallRecord> search(AuditQuery query, long before, int limit);

    /** The record of a command. */
    Optional<AuditRecord> ofCommand(String command);

    /** Records of commands that are under way and have no end yet. */
    List<AuditRecord> underWay();
}
