package org.dronemap.core.access;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * How far a way of signing in reaches; it takes from what the user's role allows and never adds to it.
 *
 * @param drones null: all of them, also those to come; others do not exist for it
 * @param permissions looking is always among them
 */
public record KeyScope(@Nullable Set<DroneId> drones, Set<Permission> permissions) {
    /** Takes nothing away. */
    public static final KeyScope ALL = new KeyScope(null, EnumSet.allOf(Permission.class));

    public KeyScope {
        drones = drones == null ? null : Set.copyOf(drones);
        EnumSet<Permission> all = EnumSet.of(Permission.VIEW);
        all.addAll(permissions);
        permissions = Collections.unmodifiableSet(all);
    }

    public boolean covers(DroneId drone) {
        return drones == null || drones.contains(drone);
    }

    public boolean coversAllDrones() {
        return drones == null;
    }

    boolean permits(Role needed) {
        Permission permission = needed.permission();
        return permission == null || permissions.contains(permission);
    }

    boolean includesDronesOf(KeyScope other) {
        return drones == null || (other.drones != null && drones.containsAll(other.drones));
    }
}
