package org.dronemap.core.lease;

/** Reasons why a user's request to take, release or hand over control of a drone is denied. */
public enum LeaseDenial {
    /** Somebody else has control. */
    HELD,
    /** Who names that epoch does not have control by it any more. */
    ENDED,
    /** Who gives control back, hands it over or refuses it does not have it. */
    NOT_HELD,
    /** Who hands control over would be the one who gets it. */
    OWN,
    /** So many wait for an answer that nobody else may ask. */
    REQUESTS_FULL,
    /** Who would get control, or a refusal, does not ask for it. */
    NOT_ASKED,
    /** Control came with a command, so that no heartbeat keeps it. */
    NOT_TAKEN
}
