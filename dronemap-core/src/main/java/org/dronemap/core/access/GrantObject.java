package org.dronemap.core.access;

import java.util.Set;
import org.dronemap.core.drone.DroneId;

/**
 * The drones that a grant covers: all of the organisation, listed ones, a fleet, or the user's own virtual drones. A
 * further kind of drone is a further case here.
 */
public sealed interface GrantObject {
    /** All drones of the organisation, also those to come. */
    record Everything() implements GrantObject {}

    /** The user's own virtual drones, and with them whichever drone serves them, unseen. */
    record Virtual() implements GrantObject {}

    /** These drones. */
    record Drones(Set<DroneId> ids) implements GrantObject {
        public Drones {
            ids = Set.copyOf(ids);
        }
    }

    /** Whatever is in the fleet at the time. */
    record OfFleet(String id) implements GrantObject {}
}
