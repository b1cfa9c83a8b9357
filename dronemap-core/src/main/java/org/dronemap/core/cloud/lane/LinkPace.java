package org.dronemap.core.cloud.lane;

/** What a message shows of the pace at which its vehicle speaks. */
public enum LinkPace {
    /** Nothing: an answer, for instance. */
    UNCHANGED,
    /** It speaks all the time. */
    STEADY,
    /** It says all in one message now and then, as over a satellite. */
    SELDOM
}
