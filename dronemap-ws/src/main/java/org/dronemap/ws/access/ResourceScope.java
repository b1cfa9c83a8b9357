package org.dronemap.ws.access;

/**
 * Owner of the resources that an operation touches: a drone, the organisation, the server, the caller, or none. The
 * services see to it; tests try it for each operation.
 */
public enum ResourceScope {
    /** Drones of the caller's organisation that no key and no grant keeps away. */
    DRONE,
    /** Things of the caller's organisation, for those from whom nothing of it is kept. */
    ORGANISATION,
    /** The same, also for those who see only what they were granted or come by a key for certain drones. */
    SHARED,
    /** Only for members of the default organisation from whom nothing of it is kept. */
    SERVER,
    /** The caller's own account. */
    OWN,
    /** Nothing of anybody's. */
    NONE
}
