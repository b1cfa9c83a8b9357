package org.dronemap.core.access;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/**
 * Permissions of a user for each drone now, by role, organisation and grants; evaluated at each call. Any thread. Any
 * thread.
 */
public interface EffectivePermissions {
    /** All operations. */
    Set<Permission> ALL = Collections.unmodifiableSet(EnumSet.allOf(Permission.class));

    /** For what the server does by itself: everything, whoever it belongs to. */
    EffectivePermissions EVERYWHERE = new EffectivePermissions() {
        @Override
        public OrganisationId organisation() {
            return OrganisationId.HOME;
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
            return HistoryVisibility.WHOLE;
        }

        @Override
        public boolean isWhole() {
            return true;
        }
    };

    OrganisationId organisation();

    /** What may be done with a drone, if the role allows it; empty: it does not exist. */
    Set<Permission> of(DroneId drone);

    /** What may be done with some drone or other; looking always is among it, for there may be nothing to see. */
    Set<Permission> somewhere();

    /** What may be done with one's own virtual drones, if the role allows it; empty: there are none. */
    Set<Permission> virtually();

    /** What is shown of what a drone did, also of one that was given away since. */
    HistoryVisibility insight(DroneId drone);

    /** All drones of the organisation, with all that the role allows. */
    boolean isWhole();
}
