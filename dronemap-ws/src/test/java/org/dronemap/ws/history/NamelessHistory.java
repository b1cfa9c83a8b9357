package org.dronemap.ws.history;

import java.time.Instant;
import java.util.List;
import java.util.Set;
import org.dronemap.core.access.EffectivePermissions;
import org.dronemap.core.access.HistoryVisibility;
import org.dronemap.core.access.Permission;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/** Rights of somebody whose drones were others' all the time, and came with their histories. */
record NamelessHistory() implements EffectivePermissions {
    private static final HistoryVisibility NAMELESS =
            new HistoryVisibility(List.of(new HistoryVisibility.Period(Instant.MIN, Instant.MAX, false)));

    @Override
    public OrganisationId organisation() {
        return new OrganisationId("rescue");
    }

    @Override
    public Set<Permission> of(DroneId drone) {
        return ALL;
    }

    @Override
    public Set<Permission> somewhere() {
        return ALL;
    }

    @Override
    public Set<Permission> virtually() {
        return ALL;
    }

    @Override
    public HistoryVisibility insight(DroneId drone) {
        return NAMELESS;
    }

    @Override
    public boolean isWhole() {
        return true;
    }
}
