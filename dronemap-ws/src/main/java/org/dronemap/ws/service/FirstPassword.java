package org.dronemap.ws.service;

import java.util.Optional;

/** Whether the server still has the administrator password it made up at its first start, and what follows from it. */
public interface FirstPassword {
    /** Why nothing but a sign-in and a password change is served; empty when everything is. */
    Optional<String> closed();

    /** A user has taken a password of their own. */
    void changed(String user);

    /** For a server that only its own machine reaches. */
    FirstPassword NEVER = new FirstPassword() {
        @Override
        public Optional<String> closed() {
            return Optional.empty();
        }

        @Override
        public void changed(String user) {
            // nothing depends on it
        }
    };
}
