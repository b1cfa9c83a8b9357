package org.dronemap.proxy.signing;

/** The kind of a change of the signing key on a vehicle: install, rotate or revoke. */
public enum KeyChangeKind {
    /** The vehicle gets the key that was made for it. */
    INSTALL,
    /** The vehicle changes over to a new key. */
    ROTATE,
    /** The vehicle gives its key up and signs no more. */
    REVOKE
}
