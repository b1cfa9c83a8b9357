package org.dronemap.core.access;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.Organisation;
import org.dronemap.core.organisation.OrganisationId;

/**
 * Stores organisations, groups, fleets, drone owners and grants; every write returns only after it is durable. Users
 * that are named must be there, and what was granted to them or to a group goes with them.
 */
public interface GrantStore {
    /** All of it, by name where there is one, else by age; the default organisation is always there. */
    OrganisationDirectory directory();

    /** Inserts or replaces. */
    void save(Organisation organisation);

    /** True when there was one; refused while users belong to it, and never the default one. */
    boolean deleteOrganisation(OrganisationId id);

    /** From now on, and after it is gone. */
    void assign(DroneId drone, OrganisationId owner);

    /** Assigns it, and remembers that it was given. */
    void give(Gift gift);

    /** Inserts or replaces. */
    void save(UserGroup group);

    /** True when there was one; with all that was granted to it. */
    boolean deleteGroup(String id);

    /** Inserts or replaces. */
    void save(Fleet fleet);

    /** True when there was one; with all grants of it. */
    boolean deleteFleet(String id);

    void add(Grant grant);

    /** True when there was one. */
    boolean deleteGrant(String id);

    /** Whether these see only what they were granted. */
    void setOnlyGranted(GrantSubject subject, boolean only);

    /** A user is gone, and with the user whatever names them here. */
    void forgetUser(String name);
}
