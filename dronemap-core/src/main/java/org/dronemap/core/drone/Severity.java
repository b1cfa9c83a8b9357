package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Severity of a vehicle's text message, gravest first (RFC 5424). */
@Stored(names = "EMERGENCY ALERT CRITICAL ERROR WARNING NOTICE INFO DEBUG")
public enum Severity {
    EMERGENCY,
    ALERT,
    CRITICAL,
    ERROR,
    WARNING,
    NOTICE,
    INFO,
    DEBUG
}
