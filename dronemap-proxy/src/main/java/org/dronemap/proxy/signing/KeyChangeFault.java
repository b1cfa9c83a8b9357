package org.dronemap.proxy.signing;

/** The reason why a change of the signing key on a vehicle failed. */
public enum KeyChangeFault {
    /** Another change of its key is under way. */
    CHANGING,
    /** There is no key to change. */
    NO_KEY,
    /** The vehicle was never heard using its key. */
    NOT_PROVEN,
    /** There is nothing to say it over. */
    NO_LINK,
    /** The link could be listened to, and nobody vouches for it. */
    LINK_NOT_SAFE,
    /** The vehicle was heard after each request, and does as before. */
    NOT_DONE,
    /** The vehicle said why not. */
    REFUSED
}
