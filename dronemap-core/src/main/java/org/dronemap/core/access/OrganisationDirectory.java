package org.dronemap.core.access;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.Organisation;
import org.dronemap.core.organisation.OrganisationId;

/**
 * All organisations, groups, fleets, grants and drone owners, as loaded from the GrantStore.
 *
 * @param owners to whom drones belong, also those that are gone; one that is not named belongs to the default organisation
 * @param gifts of drones from one organisation to another
 * @param onlyGranted those who see nothing but what they were granted; all others see by their role
 */
public record OrganisationDirectory(
        List<Organisation> organisations,
        Map<DroneId, OrganisationId> owners,
        List<UserGroup> groups,
        List<Fleet> fleets,
        List<Grant> grants,
        List<Gift> gifts,
        Set<GrantSubject> onlyGranted) {
    /** Nobody but the default organisation, and nothing granted. */
    public static final OrganisationDirectory NONE =
            new OrganisationDirectory(List.of(), Map.of(), List.of(), List.of(), List.of(), List.of(), Set.of());

    public OrganisationDirectory {
        organisations = List.copyOf(organisations);
        owners = Map.copyOf(owners);
        groups = List.copyOf(groups);
        fleets = List.copyOf(fleets);
        grants = List.copyOf(grants);
        gifts = List.copyOf(gifts);
        onlyGranted = Set.copyOf(onlyGranted);
    }
}
