package org.dronemap.core.access;

import java.time.Instant;
import java.util.EnumSet;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * An authenticated caller: user name, role, account and, where a key was used, the key's scope. The name is for people;
 * what belongs to whom goes by the account.
 *
 * @param scope how far the proof reaches
 * @param key the id of the access key that was shown; null: none, or the machine owner's
 * @param reach how far the user's own rights go
 * @param account of the user, which nobody else ever has
 */
public record Principal(
        String name, Role role, KeyScope scope, @Nullable String key, EffectivePermissions reach, String account) {
    /** A user with whole rights of the role, or what a key leaves of them. */
    public static Principal of(User user, Role role, KeyScope scope, @Nullable String key, EffectivePermissions reach) {
        return new Principal(user.name(), role, scope, key, reach, user.account());
    }

    /** One without an account of its own: a part of the server. */
    public Principal(String name, Role role, KeyScope scope, @Nullable String key, EffectivePermissions reach) {
        this(name, role, scope, key, reach, name);
    }

    /** A part of the server, which acts on all drones. */
    public Principal(String name, Role role) {
        this(name, role, KeyScope.ALL, null, EffectivePermissions.EVERYWHERE);
    }

    public OrganisationId organisation() {
        return reach.organisation();
    }

    /** Whether this can be allowed at all; whether with a certain drone is another question. */
    public boolean may(Role needed) {
        Permission permission = needed.permission();
        return role.includes(needed)
                && scope.permits(needed)
                && (permission == null || reach.somewhere().contains(permission));
    }

    public boolean may(Role needed, DroneId drone) {
        Permission permission = needed.permission();
        return role.includes(needed)
                && (permission == null || permissions(drone).contains(permission));
    }

    /**
     * With virtual drones, which any drone may serve, and which fly on without whoever started them: a proof that
     * reaches certain drones reaches none of them, and one with bounds only looks.
     */
    public boolean mayVirtually(Role needed) {
        Permission permission = needed.permission();
        return role.includes(needed)
                && scope.permits(needed)
                && scope.coversAllDrones()
                && (!scope.isBounded() || !needed.includes(Role.PLANNER))
                && (permission == null || reach.virtually().contains(permission));
    }

    /** Other drones do not exist for this one. */
    public boolean sees(DroneId drone) {
        return scope.covers(drone) && !reach.of(drone).isEmpty();
    }

    /** What is shown of what that drone did; of one that was given away since, what was before. */
    public HistoryVisibility insight(DroneId drone) {
        return scope.covers(drone) ? reach.insight(drone) : HistoryVisibility.NONE;
    }

    /** How much is shown of what that drone did then. */
    public VisibilityLevel sight(DroneId drone, Instant at) {
        return insight(drone).at(at);
    }

    /** What proof and grants leave of what the role allows with that drone; empty: it does not exist. */
    public Set<Permission> permissions(DroneId drone) {
        if (!scope.covers(drone)) {
            return Set.of();
        }
        Set<Permission> granted = reach.of(drone);
        if (granted.isEmpty() || scope.permissions().containsAll(granted)) {
            return granted;
        }
        EnumSet<Permission> both = EnumSet.copyOf(granted);
        both.retainAll(scope.permissions());
        return both;
    }

    /** Nothing of the organisation is kept from this one. */
    public boolean isWhole() {
        return scope.coversAllDrones() && reach.isWhole();
    }
}
