package org.dronemap.core.cloud.lane;

/** Pace at which a vehicle speaks, as far as one message shows it. */
public enum LinkPace {
    /** Nothing: an answer, for instance. */
    UNCHANGED,
    /** It speaks all the time. */
    STEADY,
    /** It says all in one message now and then, as over a satellite. */
    SELDOM
}
