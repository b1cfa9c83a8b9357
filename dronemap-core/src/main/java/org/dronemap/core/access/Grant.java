package org.dronemap.core.access;

import java.time.Instant;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * Permissions on certain drones, given to one user or group for a time. It takes from what a role allows, and never
 * adds to it.
 *
 * @param permissions looking is always among them
 * @param until from then on it is over; null: it does not end by itself
 */
public record Grant(
        String id,
        OrganisationId organisation,
        GrantSubject subject,
        GrantObject object,
        Set<Permission> permissions,
        Instant from,
        @Nullable Instant until,
        String madeBy,
        Instant madeAt) {
    public Grant {
        EnumSet<Permission> all = EnumSet.of(Permission.VIEW);
        all.addAll(permissions);
        permissions = Collections.unmodifiableSet(all);
    }

    public boolean isInForce(Instant now) {
        return !from.isAfter(now) && (until == null || until.isAfter(now));
    }
}
