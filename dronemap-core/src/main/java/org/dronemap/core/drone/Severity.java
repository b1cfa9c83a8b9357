package org.dronemap.core.drone;

/** How grave a vehicle's text is, gravest first (RFC 5424). */
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
