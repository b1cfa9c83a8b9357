package org.dronemap.core.access;

import java.util.List;
import org.dronemap.core.drone.DroneId;

/**
 * Stores each drone's MAVLink signing policy, signing keys and last stamp; writes return only once durable. Goes with
 * its drone.
 */
public interface LinkSecurityStore {
    List<LinkSecurity> all();

    /** Inserts or replaces; a stored stamp that is later stays. The drone must be known. */
    void save(LinkSecurity security);

    /** Raises the stamp; a stamp that is not later, or a drone without security, changes nothing. */
    void saveStamp(DroneId drone, long stamp);
}
