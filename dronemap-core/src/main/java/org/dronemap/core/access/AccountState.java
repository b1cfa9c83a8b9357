package org.dronemap.core.access;

/** Whether a user may come in. */
public enum AccountState {
    /** Asked for an account; an administrator decides. */
    WAITING,
    ACTIVE,
    /** Kept with its history, but out until an administrator lets it in again. */
    DISABLED
}
