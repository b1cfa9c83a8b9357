package org.dronemap.core.access;

import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/** A named set of drones of one organisation. */
public record Fleet(String id, OrganisationId organisation, String name, Set<DroneId> drones) {
    public Fleet {
        drones = Set.copyOf(drones);
    }
}
