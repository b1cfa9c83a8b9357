package org.dronemap.ws.account;

import java.util.Optional;

/**
 * Tells whether the generated password of the first administrator is still in use, and what it blocks until changed.
 */
public interface InitialPassword {
    /** Why nothing but a sign-in and a password change is served; empty when everything is. */
    Optional<String> closed();

    /** The first administrator of a server that only its own machine reaches may keep the password for a while. */
    boolean mayStay(String user);

    /** A user has taken a password of their own. */
    void changed(String user);
}
