package org.dronemap.core.conduct;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/**
 * Says whether virtual drones of an account may fly, and which drones may serve an organisation; any thread. Any
 * thread.
 */
public interface VirtualDroneRights {
    /** Whether that account's virtual drones may fly now. */
    boolean mayFly(String account);

    /** Whether that drone may serve virtual ones of that organisation. */
    boolean mayServe(OrganisationId organisation, DroneId drone);
}
