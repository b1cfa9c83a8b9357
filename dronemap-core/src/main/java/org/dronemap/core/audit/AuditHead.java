package org.dronemap.core.audit;

/** Where the chain ends: the number of its last record and that one's hash, which stands for all before it. */
public record AuditHead(long sequence, String hash) {
    /** Of a chain without records. */
    public static final AuditHead EMPTY = new AuditHead(0, "");
}
