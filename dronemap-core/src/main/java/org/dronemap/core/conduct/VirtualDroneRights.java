package org.dronemap.core.conduct;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/** Tells whether an account's virtual drones may fly, and which real drones may serve an organisation's. Any thread. */
public interface VirtualDroneRights {
    /** Whether that account's virtual drones may fly now. */
    boolean mayFly(String account);

    /** Whether that drone may serve virtual ones of that organisation. */
    boolean mayServe(OrganisationId organisation, DroneId drone);
}
