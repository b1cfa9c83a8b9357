package org.dronemap.core.access;

import java.util.List;
import org.dronemap.core.drone.DroneId;

/** Keeps how links are secured; every write returns only after it is durable. Goes with its drone. */
public interface LinkSecurityStore {
    List<LinkSecurity> all();

    /** Inserts or replaces; a stored stamp that is later stays. The drone must be known. */
    void save(LinkSecurity security);

    /** Raises the stamp; a stamp that is not later, or a drone without security, changes nothing. */
    void saveStamp(DroneId drone, long stamp);
}
