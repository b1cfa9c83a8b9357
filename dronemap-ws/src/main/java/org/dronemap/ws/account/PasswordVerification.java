package org.dronemap.ws.account;

import org.dronemap.core.access.User;
import org.dronemap.ws.problem.Rejection;

/** Checks a password that a user gives again, and slows down guessing as the sign-in does. Any thread. */
public interface PasswordVerification {
    /**
     * Whether that is the user's password.
     *
     * @param address where it is said from
     * @throws Rejection (throttled) after too many wrong ones
     */
    boolean isOf(User user, String password, String address);
}
