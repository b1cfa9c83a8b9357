package org.dronemap.core.access;

import java.time.InstantSource;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * In-memory registry of organisations and the grants in force; each change takes effect at once for all callers. Any
 * thread; who asks never waits.
 */
public final class GrantRegistry {
    /** Drones of recordings that play; only the newest are remembered. */
    private static final int MOST_LENT = 10_000;

    private final InstantSource clock;
    private final CopyOnWriteArrayList<Runnable> listeners = new CopyOnWriteArrayList<>();
    private volatile GrantSnapshot picture = new GrantSnapshot(OrganisationDirectory.NONE, Map.of(), 0);

    // all guarded by this
    private final Map<DroneId, OrganisationId> lent = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<DroneId, OrganisationId> eldest) {
            return size() > MOST_LENT;
        }
    };
    private long announcedEdition;

    public GrantRegistry(InstantSource clock) {
        this.clock = clock;
    }

    /** As it is kept now. */
    public OrganisationDirectory directory() {
        return picture.holdings();
    }

    /** From now on it is like this. */
    public void replace(OrganisationDirectory now) {
        synchronized (this) {
            picture = new GrantSnapshot(now, picture.lent(), picture.number() + 1);
        }
        announce();
    }

    /** To whom a drone belongs that is kept nowhere, such as one of a recording that plays; listeners hear of it later. */
    public void lend(DroneId drone, OrganisationId owner) {
        synchronized (this) {
            lent.put(drone, owner);
            picture = new GrantSnapshot(
                    picture.holdings(), Collections.unmodifiableMap(new LinkedHashMap<>(lent)), picture.number() + 1);
        }
    }

    /** To whom a drone belongs, also one that is gone. */
    public OrganisationId owner(DroneId drone) {
        return picture.owner(drone);
    }

    /** The last time that it was given away; empty: never, as far as is known. */
    public Optional<Gift> lastGift(DroneId drone) {
        return picture.lastGift(drone);
    }

    /** The rights of a user of that organisation. */
    public EffectivePermissions permissionsOf(OrganisationId organisation, String user) {
        return new GrantedPermissions(this, organisation, user);
    }

    /** All of an organisation, whatever is granted to whom. */
    public EffectivePermissions permissionsOf(OrganisationId organisation) {
        return new GrantedPermissions(this, organisation, null);
    }

    /** Whether that user sees only what was granted, by their own name or by a group. */
    public boolean isOnlyGranted(String user) {
        return picture.isOnlyGranted(user);
    }

    /** Another number whenever an answer of this book may have become another one. */
    public long edition() {
        return picture.edition(clock.instant());
    }

    /** Heard after changes, and when a grant has begun or ended; must return soon. */
    public void onChange(Runnable listener) {
        listeners.add(listener);
    }

    /** Tells the listeners, if time alone has changed something since they were last told. */
    public void announce() {
        long now = edition();
        synchronized (this) {
            if (announcedEdition == now) {
                return;
            }
            announcedEdition = now;
        }
        listeners.forEach(Runnable::run);
    }

    /** Live, so that what is taken away is gone for whoever is connected. */
    private record GrantedPermissions(
            GrantRegistry book,
            OrganisationId organisation,
            @Nullable String user) implements EffectivePermissions {
        @Override
        public Set<Permission> of(DroneId drone) {
            GrantSnapshot now = book.picture;
            if (!now.owner(drone).equals(organisation)) {
                return Set.of();
            }
            List<GrantSnapshot.ResolvedGrant> held = user == null ? null : now.held(user);
            return held == null ? ALL : GrantSnapshot.permissions(held, drone, book.clock.instant());
        }

        @Override
        public Set<Permission> somewhere() {
            List<GrantSnapshot.ResolvedGrant> held = user == null ? null : book.picture.held(user);
            return held == null ? ALL : GrantSnapshot.permissions(held, null, book.clock.instant());
        }

        @Override
        public Set<Permission> virtually() {
            List<GrantSnapshot.ResolvedGrant> held = user == null ? null : book.picture.held(user);
            return held == null ? ALL : GrantSnapshot.virtually(held, book.clock.instant());
        }

        @Override
        public HistoryVisibility insight(DroneId drone) {
            GrantSnapshot now = book.picture;
            List<GrantSnapshot.ResolvedGrant> held = user == null ? null : now.held(user);
            boolean granted = held == null
                    || !GrantSnapshot.permissions(held, drone, book.clock.instant())
                            .isEmpty();
            return granted ? now.insight(organisation, drone) : HistoryVisibility.NONE;
        }

        @Override
        public boolean isWhole() {
            return user == null || book.picture.held(user) == null;
        }
    }
}
