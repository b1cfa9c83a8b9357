package org.dronemap.ws.wiring;

import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Reach;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.conduct.VirtualRights;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/** Who may have virtual drones flown: active users from operators on, to whom nothing else or this was granted. Asked many times a second, looked up once. Any thread. */
public final class AccountRights implements VirtualRights {
    private static final long FRESH_NANOS = 1_000_000_000L;

    private final AccessStore store;
    private final GrantBook grants;
    private final ConcurrentHashMap<String, Known> known = new ConcurrentHashMap<>();

    private record Known(boolean mayFly, long nanos) {}

    public AccountRights(AccessStore store, GrantBook grants) {
        this.store = store;
        this.grants = grants;
    }

    @Override
    public boolean mayFly(String owner) {
        long now = System.nanoTime();
        Known last = known.get(owner);
        if (last == null || now - last.nanos() > FRESH_NANOS) {
            boolean may = store.user(owner)
                    .filter(User::isActive)
                    .filter(this::isGranted)
                    .isPresent();
            last = new Known(may, now);
            known.put(owner, last);
        }
        return last.mayFly();
    }

    @Override
    public boolean mayServe(OrganisationId organisation, DroneId drone) {
        return grants.owner(drone).equals(organisation);
    }

    private boolean isGranted(User user) {
        Reach reach = grants.reach(user.organisation(), user.name());
        return new Principal(user.name(), user.role(), KeyScope.ALL, null, reach).mayVirtually(Role.OPERATOR);
    }
}
