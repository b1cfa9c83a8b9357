package org.dronemap.core.audit;

/**
 * An audit entry with its number and hash in the audit chain.
 *
 * @param sequence from 1, without gaps
 * @param hash over all of this record and the hash of the one before
 */
public record AuditRecord(long sequence, AuditEntry entry, String hash) {
    public AuditHead head() {
        return new AuditHead(sequence, hash);
    }
}
