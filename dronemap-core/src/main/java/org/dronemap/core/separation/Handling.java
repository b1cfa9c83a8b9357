package org.dronemap.core.separation;

/** Authority over a drone: whether it may be moved now so that it keeps apart from others. */
public enum Handling {
    /** It is commanded from here by an operation, or flies a mission that nobody holds: it may be held or moved. */
    COMMANDED,
    /** An operation leads it by setpoints, and keeps it apart from all others itself. */
    STEERED,
    /** A person, a pilot or another station has it, or nobody here knows it: others keep apart from it. */
    FOREIGN
}
