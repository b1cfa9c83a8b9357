package org.dronemap.core.audit;

import org.dronemap.core.stored.Stored;

/** How what was asked for ended; {@code UNDER_WAY} as long as it has not. */
@Stored(names = "UNDER_WAY SUCCEEDED REFUSED FAILED TIMED_OUT SUPERSEDED UNKNOWN")
public enum AuditOutcome {
    UNDER_WAY,
    SUCCEEDED,
    REFUSED,
    FAILED,
    TIMED_OUT,
    SUPERSEDED,
    UNKNOWN
}
