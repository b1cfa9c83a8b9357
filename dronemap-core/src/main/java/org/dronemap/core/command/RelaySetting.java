package org.dronemap.core.command;

/** What becomes of a relay. */
public enum RelaySetting {
    OFF,
    ON,
    TOGGLE
}
