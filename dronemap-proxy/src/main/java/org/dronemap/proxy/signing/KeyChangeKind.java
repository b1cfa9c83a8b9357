package org.dronemap.proxy.signing;

/** The kind of a key change on a vehicle. */
public enum KeyChangeKind {
    /** The vehicle gets the key that was made for it. */
    INSTALL,
    /** The vehicle changes over to a new key. */
    ROTATE,
    /** The vehicle gives its key up and signs no more. */
    REVOKE
}
