package org.dronemap.store;

/** The greatest number of sign-in sessions that a store keeps for one user, the same in every kind of store. */
public final class UserSessionLimit {
    public static final int PER_USER = 50;

    private UserSessionLimit() {}
}
