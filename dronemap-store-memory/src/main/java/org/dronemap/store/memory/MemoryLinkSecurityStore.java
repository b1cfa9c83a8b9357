package org.dronemap.store.memory;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.store.StoreException;

/**
 * Keeps each drone's signing policy, MAVLink signing keys and last signing stamp in memory, for tests. Thread-safe:
 * every method holds the object's lock.
 */
public final class MemoryLinkSecurityStore implements LinkSecurityStore {
    private final DroneStore drones;
    private final Map<DroneId, LinkSecurity> kept = new HashMap<>();

    /** {@code drones} are those that can be secured. */
    public MemoryLinkSecurityStore(DroneStore drones) {
        this.drones = drones;
    }

    @Override
    public synchronized List<LinkSecurity> all() {
        kept.keySet().removeIf(drone -> !isKnown(drone));
        return kept.values().stream()
                .sorted(Comparator.comparing(security -> security.drone().value()))
                .toList();
    }

    @Override
    public synchronized void save(LinkSecurity security) {
        if (!isKnown(security.drone())) {
            throw new StoreException("There is no drone " + security.drone() + " whose link could be secured.");
        }
        LinkSecurity before = kept.get(security.drone());
        kept.put(security.drone(), stamped(security, before == null ? 0 : before.stamp()));
    }

    @Override
    public synchronized void saveStamp(DroneId drone, long stamp) {
        kept.computeIfPresent(drone, (id, security) -> stamped(security, stamp));
    }

    private boolean isKnown(DroneId id) {
        return drones.drones().stream().anyMatch(drone -> drone.id().equals(id));
    }

    private static LinkSecurity stamped(LinkSecurity security, long stamp) {
        return new LinkSecurity(
                security.drone(),
                security.policy(),
                security.key(),
                security.nextKey(),
                security.proven(),
                Math.max(security.stamp(), stamp));
    }
}
