package org.dronemap.proxy.outlet;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.core.access.OutletKey;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.access.OutletSystemId;

/** Keeps keys and numbers in memory, for whoever. */
final class TestOutletStore implements OutletStore {
    private final Map<String, OutletKey> keys = new ConcurrentHashMap<>();
    private final List<OutletSystemId> numbers = new CopyOnWriteArrayList<>();

    @Override
    public List<OutletKey> keys() {
        return List.copyOf(keys.values());
    }

    @Override
    public void saveKey(OutletKey key) {
        keys.put(key.user(), key);
    }

    @Override
    public void saveStamp(String user, long stamp) {
        keys.computeIfPresent(user, (name, key) -> new OutletKey(name, key.key(), Math.max(stamp, key.stamp())));
    }

    @Override
    public boolean deleteKey(String user) {
        return keys.remove(user) != null;
    }

    @Override
    public List<OutletSystemId> numbers() {
        return List.copyOf(numbers);
    }

    @Override
    public void saveNumber(OutletSystemId number) {
        numbers.add(number);
    }
}
