package org.dronemap.ws.operation;

import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.EffectivePermissions;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.conduct.OperationRights;
import org.dronemap.core.conduct.VirtualDroneRights;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/**
 * Tells what the owners of mission runs, follows and virtual drones may fly now, from a cache of one second. Asked many
 * times a second, looked up once. Any thread.
 */
public final class OwnerRightsCache implements VirtualDroneRights, OperationRights, OperationOwners {
    private static final long FRESH_NANOS = 1_000_000_000L;

    private final AccessStore store;
    private final GrantRegistry grants;
    private final Time time;
    private final ConcurrentHashMap<String, Known> known = new ConcurrentHashMap<>();

    /** Null: there is no such user who may do anything now. */
    private record Known(@Nullable Principal principal, long nanos) {}

    public OwnerRightsCache(AccessStore store, GrantRegistry grants, Time time) {
        this.store = store;
        this.grants = grants;
        this.time = time;
    }

    @Override
    public boolean mayFly(String account) {
        Principal principal = principal(account);
        return principal != null && principal.mayVirtually(Role.OPERATOR);
    }

    @Override
    public Optional<String> whyNot(SavedOperation operation, DroneId drone) {
        Principal principal = principal(operation.account());
        return principal != null && principal.may(Role.OPERATOR, drone)
                ? Optional.empty()
                : Optional.of(operation.owner() + " may not command it any more.");
    }

    @Override
    public Optional<Principal> find(String account) {
        return Optional.ofNullable(principal(account));
    }

    private @Nullable Principal principal(String account) {
        long now = time.nanos();
        Known last = known.get(account);
        if (last == null || now - last.nanos() > FRESH_NANOS) {
            Principal principal = store.users().stream()
                    .filter(user -> user.account().equals(account) && user.isActive())
                    .findFirst()
                    .map(this::principal)
                    .orElse(null);
            last = new Known(principal, now);
            known.put(account, last);
        }
        return last.principal();
    }

    @Override
    public boolean mayServe(OrganisationId organisation, DroneId drone) {
        return grants.owner(drone).equals(organisation);
    }

    private Principal principal(User user) {
        EffectivePermissions reach = grants.permissionsOf(user.organisation(), user.name());
        return Principal.of(user, user.role(), KeyScope.ALL, null, reach);
    }
}
