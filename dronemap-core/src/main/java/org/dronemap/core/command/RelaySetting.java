package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** What becomes of a relay. */
@Stored(names = "OFF ON TOGGLE")
public enum RelaySetting {
    OFF,
    ON,
    TOGGLE
}
