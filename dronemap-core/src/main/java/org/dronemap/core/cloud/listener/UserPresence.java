package org.dronemap.core.cloud.listener;

import org.dronemap.core.drone.DroneId;

/** Knows who is there: looks at a drone by something that is alive, such as a page. Any thread; answers at once. */
public interface UserPresence {
    boolean isThere(String user, DroneId drone);
}
