package org.dronemap.core.audit;

import org.jspecify.annotations.Nullable;

/**
 * Result of verifying the audit chain.
 *
 * @param head where it ends, or the last record that is good
 * @param firstBad the number of the first record that is not as it was, or is missing; null: none, or not known which
 * @param why a sentence for people; null: all is as it was
 */
public record AuditVerdict(
        AuditHead head, @Nullable Long firstBad, @Nullable String why) {
    public boolean isSound() {
        return why == null;
    }

    public String sentence() {
        return why != null
                ? why
                : head.sequence() == 0
                        ? "There are no records yet."
                        : "All " + head.sequence() + " records are as they were written.";
    }
}
