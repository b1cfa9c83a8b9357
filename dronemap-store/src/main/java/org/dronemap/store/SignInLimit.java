package org.dronemap.store;

/** How many sessions are kept for one user, in every adapter alike; those that end first make room. */
public final class SignInLimit {
    public static final int PER_USER = 50;

    private SignInLimit() {}
}
