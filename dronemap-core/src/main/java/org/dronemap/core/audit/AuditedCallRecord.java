package org.dronemap.core.audit;

import org.jspecify.annotations.Nullable;

/** The record of a call, with its end where that came later; what people look at. */
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
