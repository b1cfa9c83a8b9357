package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** New state of a relay: off, on or toggled. */
@Stored(names = "OFF ON TOGGLE")
public enum RelaySetting {
    OFF,
    ON,
    TOGGLE
}
