package org.dronemap.ws.user;

/** Who may make an account of their own. */
public enum Registration {
    /** Everybody; an administrator then lets them in, or an invitation does. */
    APPROVAL,
    /** Only who was invited. */
    INVITATION,
    /** Nobody. */
    OFF
}
