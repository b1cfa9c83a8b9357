package org.dronemap.proxy.signing;

/** The decision whether a received frame may speak for its drone, by its MAVLink signature. */
public enum FrameAdmission {
    /** It speaks for the drone, and its signature proves that. */
    PROVEN,
    /** It speaks for the drone; nothing proves it and nothing has to. */
    ADMITTED,
    /** It may be looked at, but is no sign of life and moves nothing: a radio's own report, which is never signed. */
    ASIDE,
    /** It speaks for nobody. */
    REFUSED
}
