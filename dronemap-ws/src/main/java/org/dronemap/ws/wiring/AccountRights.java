package org.dronemap.ws.wiring;

import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Reach;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.conduct.OperationRights;
import org.dronemap.core.conduct.VirtualRights;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.time.Time;
import org.dronemap.ws.service.FollowReliefs;
import org.jspecify.annotations.Nullable;

/**
 * Whom the cloud may fly for: active users from operators on, to whom nothing else or this was granted. Asked many times a
 * second, looked up once. Any thread.
 */
public final class AccountRights implements VirtualRights, OperationRights, FollowReliefs.Owners {
    private static final long FRESH_NANOS = 1_000_000_000L;

    private final AccessStore store;
    private final GrantBook grants;
    private final Time time;
    private final ConcurrentHashMap<String, Known> known = new ConcurrentHashMap<>();

    /** Null: there is no such user who may do anything now. */
    private record Known(@Nullable Principal principal, long nanos) {}

    public AccountRights(AccessStore store, GrantBook grants, Time time) {
        this.store = store;
        this.grants = grants;
        this.time = time;
    }

    @Override
    public boolean mayFly(String owner) {
        Principal principal = principal(owner);
        return principal != null && principal.mayVirtually(Role.OPERATOR);
    }

    @Override
    public Optional<String> whyNot(String owner, DroneId drone) {
        Principal principal = principal(owner);
        return principal != null && principal.may(Role.OPERATOR, drone)
                ? Optional.empty()
                : Optional.of(owner + " may not command it any more.");
    }

    @Override
    public Optional<Principal> find(String owner) {
        return Optional.ofNullable(principal(owner));
    }

    private @Nullable Principal principal(String owner) {
        long now = time.nanos();
        Known last = known.get(owner);
        if (last == null || now - last.nanos() > FRESH_NANOS) {
            Principal principal = store.user(owner)
                    .filter(User::isActive)
                    .map(this::principal)
                    .orElse(null);
            last = new Known(principal, now);
            known.put(owner, last);
        }
        return last.principal();
    }

    @Override
    public boolean mayServe(OrganisationId organisation, DroneId drone) {
        return grants.owner(drone).equals(organisation);
    }

    private Principal principal(User user) {
        Reach reach = grants.reach(user.organisation(), user.name());
        return new Principal(user.name(), user.role(), KeyScope.ALL, null, reach);
    }
}
