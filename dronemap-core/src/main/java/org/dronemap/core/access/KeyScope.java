package org.dronemap.core.access;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.zone.FlightBounds;
import org.jspecify.annotations.Nullable;

/**
 * Limits of a credential such as an access key: drones, permissions and flight bounds; only restricts the role.
 *
 * @param drones null: all of them, also those to come; others do not exist for it
 * @param permissions looking is always among them
 * @param bounds what flights that it commands stay within: all of them, each within the one before
 */
public record KeyScope(@Nullable Set<DroneId> drones, Set<Permission> permissions, List<FlightBounds> bounds) {
    /** Takes nothing away. */
    public static final KeyScope ALL = new KeyScope(null, EnumSet.allOf(Permission.class));

    public KeyScope {
        drones = drones == null ? null : Set.copyOf(drones);
        EnumSet<Permission> all = EnumSet.of(Permission.VIEW);
        all.addAll(permissions);
        permissions = Collections.unmodifiableSet(all);
        bounds = List.copyOf(bounds);
    }

    /** Wherever one may fly at all. */
    public KeyScope(@Nullable Set<DroneId> drones, Set<Permission> permissions) {
        this(drones, permissions, List.of());
    }

    public boolean covers(DroneId drone) {
        return drones == null || drones.contains(drone);
    }

    public boolean coversAllDrones() {
        return drones == null;
    }

    /** It commands flights only here and there. */
    public boolean isBounded() {
        return !bounds.isEmpty();
    }

    /** The closest of all bounds; null: there are none. */
    public @Nullable FlightBounds innermost() {
        return bounds.isEmpty() ? null : bounds.get(bounds.size() - 1);
    }

    /** Within these bounds, too. */
    public KeyScope boundedBy(FlightBounds closer) {
        if (closer.equals(innermost())) {
            return this;
        }
        List<FlightBounds> all = new ArrayList<>(bounds);
        all.add(closer);
        return new KeyScope(drones, permissions, all);
    }

    boolean permits(Role needed) {
        Permission permission = needed.permission();
        return permission == null || permissions.contains(permission);
    }

    boolean includesDronesOf(KeyScope other) {
        return drones == null || (other.drones != null && drones.containsAll(other.drones));
    }

    /**
     * The part in which these bounds go beyond those. All of those must hold here, too: two judgements of one leg may
     * differ by the room that each of them keeps from its own edge.
     */
    Optional<FlightBounds.Side> boundsBeyond(KeyScope outer) {
        FlightBounds widest = outer.innermost();
        FlightBounds own = innermost();
        if (widest == null) {
            return Optional.empty();
        }
        if (own == null) {
            return Optional.of(widest.area() == null ? FlightBounds.Side.ALTITUDE : FlightBounds.Side.AREA);
        }
        Optional<FlightBounds.Side> side = own.beyond(widest);
        boolean allHold = bounds.containsAll(outer.bounds);
        return side.isPresent() || allHold ? side : Optional.of(FlightBounds.Side.AREA);
    }
}
