package org.dronemap.core.access;

import java.time.Instant;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.zone.FlightBounds;
import org.jspecify.annotations.Nullable;

/**
 * All rights of an access key: role, scope and expiry, compared with those of the key that it was made from. A key made
 * from another one stays within it.
 *
 * @param expiresAt from then on it allows nothing; null: it does not end by itself
 */
public record KeyRights(Role role, KeyScope scope, @Nullable Instant expiresAt) {

    /** A part of a key's rights that goes beyond what it was made from. */
    public enum Excess {
        ROLE,
        DRONES,
        PERMISSIONS,
        AREA,
        ALTITUDE,
        EXPIRY
    }

    public boolean isOver(Instant now) {
        return expiresAt != null && !expiresAt.isAfter(now);
    }

    /** Whether it allows at that time what takes this role, with that drone. */
    public boolean permit(Role needed, DroneId drone, Instant now) {
        return !isOver(now) && role.includes(needed) && scope.permits(needed) && scope.covers(drone);
    }

    /** Where these rights go beyond those; empty when everything that these allow those allow, too. */
    public Optional<Excess> beyond(KeyRights outer) {
        if (!outer.role.includes(role)) {
            return Optional.of(Excess.ROLE);
        }
        if (!outer.scope.includesDronesOf(scope)) {
            return Optional.of(Excess.DRONES);
        }
        if (!outer.scope.permissions().containsAll(scope.permissions())) {
            return Optional.of(Excess.PERMISSIONS);
        }
        Optional<FlightBounds.Side> side = scope.boundsBeyond(outer.scope);
        if (side.isPresent()) {
            return Optional.of(side.get() == FlightBounds.Side.AREA ? Excess.AREA : Excess.ALTITUDE);
        }
        boolean longer = outer.expiresAt != null && (expiresAt == null || expiresAt.isAfter(outer.expiresAt));
        return longer ? Optional.of(Excess.EXPIRY) : Optional.empty();
    }
}
