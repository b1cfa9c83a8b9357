package org.dronemap.core.access;

import java.util.List;

/**
 * Stores, for the outlet, each user's signing key and the system ids that the user's ground stations see for drones.
 * Goes with its user, and a number with its drone as well. Every write returns only after it is durable.
 */
public interface OutletStore {
    List<OutletKey> keys();

    /** Inserts or replaces; a stored stamp that is later stays. The user must be known. */
    void saveKey(OutletKey key);

    /** Raises the stamp; a stamp that is not later, or a user without a key, changes nothing. */
    void saveStamp(String user, long stamp);

    /** True when there was one. */
    boolean deleteKey(String user);

    List<OutletSystemId> numbers();

    /** Nothing changes when that user has given the drone a number already, or the number to another drone, or either is gone. */
    void saveNumber(OutletSystemId number);
}
