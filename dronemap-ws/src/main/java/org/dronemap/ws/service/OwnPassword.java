package org.dronemap.ws.service;

import org.dronemap.core.access.User;

/** Compares passwords wherever somebody gives one, and slows down who guesses, as at the sign-in. Any thread. */
public interface OwnPassword {
    /**
     * Whether that is the user's password.
     *
     * @param address where it is said from
     * @throws Rejection (throttled) after too many wrong ones
     */
    boolean isOf(User user, String password, String address);
}
