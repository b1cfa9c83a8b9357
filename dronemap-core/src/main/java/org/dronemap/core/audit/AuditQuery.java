package org.dronemap.core.audit;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Search criteria for audit records; null matches everything.
 *
 * @param operation a part of its name, whatever the case
 * @param from inclusive
 * @param until exclusive
 */
public record AuditQuery(
        @Nullable String user,
        @Nullable String organisation,
        @Nullable String drone,
        @Nullable String operation,
        @Nullable String face,
        @Nullable AuditOutcome outcome,
        @Nullable Instant from,
        @Nullable Instant until) {
    public static final AuditQuery ALL = new AuditQuery(null, null, null, null, null, null, null, null);
}
