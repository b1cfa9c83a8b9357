package org.dronemap.ws.security.oidc;

/** Thrown when a sign-in by an OpenID Connect provider fails; its message is for the log, not for the user. */
final class OidcSignInException extends Exception {
    private static final long serialVersionUID = 1L;

    OidcSignInException(String why) {
        super(why);
    }

    OidcSignInException(String why, Exception cause) {
        super(why + ": " + cause.getMessage(), cause);
    }
}
