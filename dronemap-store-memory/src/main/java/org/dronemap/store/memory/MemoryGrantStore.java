package org.dronemap.store.memory;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.access.Fleet;
import org.dronemap.core.access.Gift;
import org.dronemap.core.access.Grant;
import org.dronemap.core.access.GrantObject;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.GrantSubject;
import org.dronemap.core.access.OrganisationDirectory;
import org.dronemap.core.access.UserGroup;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.Organisation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.store.GrantOrdering;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;

/**
 * Keeps organisations, groups, fleets and grants in memory, for tests. Thread-safe: every method holds the object's
 * lock.
 */
public final class MemoryGrantStore implements GrantStore {
    private final Map<OrganisationId, Organisation> organisations = new HashMap<>();
    private final Map<DroneId, OrganisationId> owners = new HashMap<>();
    private final Map<String, UserGroup> groups = new HashMap<>();
    private final Map<String, Fleet> fleets = new HashMap<>();
    private final Map<String, Grant> grants = new HashMap<>();
    private final List<Gift> gifts = new ArrayList<>();
    private final Set<GrantSubject> onlyGranted = new HashSet<>();

    @Override
    public synchronized OrganisationDirectory directory() {
        return new OrganisationDirectory(
                organisations.values().stream()
                        .sorted(GrantOrdering.ORGANISATIONS)
                        .toList(),
                owners,
                groups.values().stream().sorted(GrantOrdering.GROUPS).toList(),
                fleets.values().stream().sorted(GrantOrdering.FLEETS).toList(),
                grants.values().stream().sorted(GrantOrdering.GRANTS).toList(),
                gifts.stream().sorted(GrantOrdering.GIFTS).toList(),
                onlyGranted);
    }

    @Override
    public synchronized void save(Organisation organisation) {
        organisations.put(
                organisation.id(),
                new Organisation(organisation.id(), organisation.name(), StoredInstant.of(organisation.madeAt())));
    }

    @Override
    public synchronized boolean deleteOrganisation(OrganisationId id) {
        groups.values().stream()
                .filter(group -> group.organisation().equals(id))
                .map(UserGroup::id)
                .collect(Collectors.toSet())
                .forEach(this::deleteGroup);
        fleets.values().removeIf(fleet -> fleet.organisation().equals(id));
        grants.values().removeIf(grant -> grant.organisation().equals(id));
        return organisations.remove(id) != null;
    }

    @Override
    public synchronized void assign(DroneId drone, OrganisationId owner) {
        owners.put(drone, owner);
    }

    @Override
    public synchronized void give(Gift gift) {
        owners.put(gift.drone(), gift.to());
        gifts.add(new Gift(
                gift.drone(), gift.droneName(), gift.from(), gift.to(), StoredInstant.of(gift.at()), gift.histories()));
    }

    @Override
    public synchronized void save(UserGroup group) {
        groups.put(group.id(), group);
    }

    @Override
    public synchronized boolean deleteGroup(String id) {
        forget(new GrantSubject.OfGroup(id));
        return groups.remove(id) != null;
    }

    @Override
    public synchronized void save(Fleet fleet) {
        fleets.put(fleet.id(), fleet);
    }

    @Override
    public synchronized boolean deleteFleet(String id) {
        grants.values().removeIf(grant -> grant.object().equals(new GrantObject.OfFleet(id)));
        return fleets.remove(id) != null;
    }

    @Override
    public synchronized void add(Grant grant) {
        grants.put(
                grant.id(),
                new Grant(
                        grant.id(),
                        grant.organisation(),
                        grant.subject(),
                        grant.object(),
                        grant.permissions(),
                        StoredInstant.of(grant.from()),
                        storedOrNull(grant.until()),
                        grant.madeBy(),
                        StoredInstant.of(grant.madeAt())));
    }

    private static @Nullable Instant storedOrNull(@Nullable Instant time) {
        return time == null ? null : StoredInstant.of(time);
    }

    @Override
    public synchronized boolean deleteGrant(String id) {
        return grants.remove(id) != null;
    }

    @Override
    public synchronized void setOnlyGranted(GrantSubject subject, boolean only) {
        if (only) {
            onlyGranted.add(subject);
        } else {
            onlyGranted.remove(subject);
        }
    }

    @Override
    public synchronized void forgetUser(String name) {
        forget(new GrantSubject.OfUser(name));
        groups.replaceAll((id, group) -> {
            Set<String> others = new LinkedHashSet<>(group.members());
            others.remove(name);
            return new UserGroup(id, group.organisation(), group.name(), others);
        });
    }

    private void forget(GrantSubject subject) {
        grants.values().removeIf(grant -> grant.subject().equals(subject));
        onlyGranted.remove(subject);
    }
}
