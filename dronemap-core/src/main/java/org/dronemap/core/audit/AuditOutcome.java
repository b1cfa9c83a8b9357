package org.dronemap.core.audit;

import org.dronemap.core.stored.Stored;

/** Outcome of an audited call; {@code UNDER_WAY} until it has ended. */
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
