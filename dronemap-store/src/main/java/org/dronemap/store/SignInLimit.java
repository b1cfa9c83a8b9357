package org.dronemap.store;

/** The greatest number of sessions for one user, the same in every adapter. */
public final class SignInLimit {
    public static final int PER_USER = 50;

    private SignInLimit() {}
}
