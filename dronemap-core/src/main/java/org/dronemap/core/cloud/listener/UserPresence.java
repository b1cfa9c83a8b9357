package org.dronemap.core.cloud.listener;

import org.dronemap.core.drone.DroneId;

/**
 * Tells whether a user is watching a drone now, by a live connection such as an open page. Any thread; answers at once.
 */
public interface UserPresence {
    boolean isThere(String user, DroneId drone);
}
