package org.dronemap.core.audit;

/** Head of the audit chain: number and hash of its last record, which stands for all before it. */
public record AuditHead(long sequence, String hash) {
    /** Of a chain without records. */
    public static final AuditHead EMPTY = new AuditHead(0, "");
}
