package org.dronemap.core.audit;

/**
 * An entry in its place in the chain.
 *
 * @param sequence from 1, without gaps
 * @param hash over all of this record and the hash of the one before
 */
public record AuditRecord(long sequence, AuditEntry entry, String hash) {
    public AuditHead head() {
        return new AuditHead(sequence, hash);
    }
}
