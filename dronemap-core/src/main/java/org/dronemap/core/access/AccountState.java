package org.dronemap.core.access;

import org.dronemap.core.stored.Stored;

/** State of a user account: waiting for approval, active or disabled. */
@Stored(names = "WAITING ACTIVE DISABLED")
public enum AccountState {
    /** Asked for an account; an administrator decides. */
    WAITING,
    ACTIVE,
    /** Kept with its history, but out until an administrator lets it in again. */
    DISABLED
}
