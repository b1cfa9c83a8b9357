package org.dronemap.core.audit;

/** How what was asked for ended; {@code UNDER_WAY} as long as it has not. */
public enum AuditOutcome {
    UNDER_WAY,
    SUCCEEDED,
    REFUSED,
    FAILED,
    TIMED_OUT,
    SUPERSEDED,
    UNKNOWN
}
