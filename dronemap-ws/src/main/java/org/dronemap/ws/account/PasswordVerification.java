package org.dronemap.ws.account;

import org.dronemap.core.access.User;
import org.dronemap.ws.problem.Rejection;

/** Compares passwords wherever somebody gives one, and slows down who guesses, as at the sign-in. Any thread. */
public interface PasswordVerification {
    /**
     * Whether that is the user's password.
     *
     * @param address where it is said from
     * @throws Rejection (throttled) after too many wrong ones
     */
    boolean isOf(User user, String password, String address);
}
