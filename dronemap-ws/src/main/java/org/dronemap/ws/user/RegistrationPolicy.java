package org.dronemap.ws.user;

/** Policy for who may make an account: everybody subject to approval, invited people only, or nobody. */
public enum RegistrationPolicy {
    /** Everybody; an administrator then lets them in, or an invitation does. */
    APPROVAL,
    /** Only who was invited. */
    INVITATION,
    /** Nobody. */
    OFF
}
