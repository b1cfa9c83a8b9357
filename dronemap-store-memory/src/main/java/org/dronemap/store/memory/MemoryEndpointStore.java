package org.dronemap.store.memory;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.link.DtlsKey;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.link.SavedEndpoint;
import org.dronemap.store.StoredInstant;

/**
 * Keeps added endpoints, the DTLS keys of vehicles and the keys of robots in memory, for tests. Thread-safe: every
 * method holds the object's lock.
 */
public final class MemoryEndpointStore implements EndpointStore {
    private final Map<String, SavedEndpoint> links = new HashMap<>();
    private final Map<String, DtlsKey> keys = new HashMap<>();
    private final Map<DroneId, RobotKey> robotKeys = new HashMap<>();

    @Override
    public synchronized List<SavedEndpoint> links() {
        return links.values().stream()
                .sorted(Comparator.comparing(SavedEndpoint::addedAt).thenComparing(SavedEndpoint::id))
                .toList();
    }

    @Override
    public synchronized boolean addLink(SavedEndpoint link) {
        boolean taken = links.values().stream()
                .anyMatch(other -> other.id().equals(link.id()) || other.url().equals(link.url()));
        if (!taken) {
            links.put(
                    link.id(),
                    new SavedEndpoint(link.id(), link.url(), link.addedBy(), StoredInstant.of(link.addedAt())));
        }
        return !taken;
    }

    @Override
    public synchronized boolean deleteLink(String id) {
        return links.remove(id) != null;
    }

    @Override
    public synchronized List<DtlsKey> keys() {
        return keys.values().stream()
                .sorted(Comparator.comparing(DtlsKey::madeAt).thenComparing(DtlsKey::identity))
                .toList();
    }

    @Override
    public synchronized void saveKey(DtlsKey key) {
        keys.put(
                key.identity(),
                new DtlsKey(
                        key.identity(), key.label(), key.sealedSecret(), key.madeBy(), StoredInstant.of(key.madeAt())));
    }

    @Override
    public synchronized boolean deleteKey(String identity) {
        return keys.remove(identity) != null;
    }

    @Override
    public synchronized List<RobotKey> robotKeys() {
        return robotKeys.values().stream()
                .sorted(Comparator.comparing(RobotKey::madeAt)
                        .thenComparing(key -> key.drone().value()))
                .toList();
    }

    @Override
    public synchronized void saveRobotKey(RobotKey key) {
        robotKeys.put(
                key.drone(),
                new RobotKey(
                        key.drone(),
                        key.label(),
                        key.systemId(),
                        key.owner(),
                        key.hash(),
                        key.madeBy(),
                        key.account(),
                        StoredInstant.of(key.madeAt())));
    }

    @Override
    public synchronized boolean deleteRobotKey(DroneId drone) {
        return robotKeys.remove(drone) != null;
    }
}
