package org.dronemap.core.access;

import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Who asks, once it is proved.
 *
 * @param scope how far the proof reaches
 * @param key the id of the access key that was shown; null: none, or the machine owner's
 */
public record Principal(
        String name, Role role, KeyScope scope, @Nullable String key) {
    /** A user in person. */
    public Principal(String name, Role role) {
        this(name, role, KeyScope.ALL, null);
    }

    public boolean may(Role needed) {
        return role.includes(needed) && scope.permits(needed);
    }

    /** Other drones do not exist for this one. */
    public boolean sees(DroneId drone) {
        return scope.covers(drone);
    }
}
