package org.dronemap.core.audit;

import org.jspecify.annotations.Nullable;

/** The audit record of a call joined with the record of its end; as shown to people. */
public record AuditedCallRecord(
        AuditRecord record, @Nullable AuditRecord ending) {
    private AuditEntry last() {
        return ending == null ? record.entry() : ending.entry();
    }

    public AuditOutcome outcome() {
        return last().outcome();
    }

    public @Nullable String reason() {
        return last().reason();
    }

    public @Nullable Long latencyMillis() {
        return last().latencyMillis();
    }
}
