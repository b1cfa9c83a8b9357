package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/** Way a vehicle's speed is planned in wind: it keeps its ground speed or its airspeed, or feels no wind. */
@Stored(names = "KEEPS_GROUND_SPEED KEEPS_AIRSPEED UNTOUCHED")
public enum WindResponse {
    /** Copters on a mission: flies faster through the air against the wind, up to its greatest airspeed. */
    KEEPS_GROUND_SPEED,
    /** Aeroplanes: the wind adds to what it flies through the air. */
    KEEPS_AIRSPEED,
    /** On the ground, or in the water. */
    UNTOUCHED
}
