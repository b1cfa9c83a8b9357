package org.dronemap.store.memory;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.OutletKey;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.access.OutletSystemId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.store.StoreException;

/**
 * Keeps in memory, for tests, users' outlet keys and the system ids by which their ground stations know drones.
 * Thread-safe: every method holds the object's lock.
 */
public final class MemoryOutletStore implements OutletStore {
    private final AccessStore access;
    private final DroneStore drones;
    private final Map<String, OutletKey> keys = new TreeMap<>();
    private final List<OutletSystemId> numbers = new ArrayList<>();

    /** {@code access} and {@code drones} know the users and drones that there are. */
    public MemoryOutletStore(AccessStore access, DroneStore drones) {
        this.access = access;
        this.drones = drones;
    }

    @Override
    public synchronized List<OutletKey> keys() {
        keys.keySet().removeIf(user -> !isUser(user));
        return List.copyOf(keys.values());
    }

    @Override
    public synchronized void saveKey(OutletKey key) {
        if (!isUser(key.user())) {
            throw new StoreException("There is no user " + key.user() + " who could have a key.");
        }
        OutletKey before = keys.get(key.user());
        long stamp = before == null ? key.stamp() : Math.max(before.stamp(), key.stamp());
        keys.put(key.user(), new OutletKey(key.user(), key.key(), stamp));
    }

    @Override
    public synchronized void saveStamp(String user, long stamp) {
        keys.computeIfPresent(user, (name, key) -> new OutletKey(name, key.key(), Math.max(key.stamp(), stamp)));
    }

    @Override
    public synchronized boolean deleteKey(String user) {
        return keys.remove(user) != null;
    }

    @Override
    public synchronized List<OutletSystemId> numbers() {
        numbers.removeIf(number -> !isUser(number.user()) || !isDrone(number.drone()));
        return numbers.stream()
                .sorted(Comparator.comparing(OutletSystemId::user).thenComparing(OutletSystemId::systemId))
                .toList();
    }

    @Override
    public synchronized void saveNumber(OutletSystemId number) {
        boolean taken = numbers.stream()
                .filter(other -> other.user().equals(number.user()))
                .anyMatch(other -> other.drone().equals(number.drone()) || other.systemId() == number.systemId());
        if (!taken && isUser(number.user()) && isDrone(number.drone())) {
            numbers.add(number);
        }
    }

    private boolean isUser(String name) {
        return access.user(name).isPresent();
    }

    private boolean isDrone(DroneId id) {
        return drones.drones().stream().anyMatch(drone -> drone.id().equals(id));
    }
}
