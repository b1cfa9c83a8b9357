package org.dronemap.ws.security.oidc;

/** A sign-in by the provider that failed; for the log, as it tells of configurations and attacks. */
final class OidcSignInException extends Exception {
    private static final long serialVersionUID = 1L;

    OidcSignInException(String why) {
        super(why);
    }

    OidcSignInException(String why, Exception cause) {
        super(why + ": " + cause.getMessage(), cause);
    }
}
