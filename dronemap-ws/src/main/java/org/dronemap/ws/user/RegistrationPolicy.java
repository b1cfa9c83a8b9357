package org.dronemap.ws.user;

/** Policy for making an account of one's own. */
public enum RegistrationPolicy {
    /** Everybody; an administrator then lets them in, or an invitation does. */
    APPROVAL,
    /** Only who was invited. */
    INVITATION,
    /** Nobody. */
    OFF
}
