package org.dronemap.proxy.outlet.rights;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.OutletKey;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.Frame;

/**
 * The outlet keys of all users; finds the user of a signed frame by trying keys, within a limit on attempts. Any
 * thread; changes wait for the store.
 */
public final class OutletKeys {
    /** About a twentieth of a processor. */
    private static final long TRIALS_PER_SECOND = 50_000;

    private static final long SECOND_NANOS = 1_000_000_000L;

    private final OutletStore store;
    private final Time time;
    private final Map<String, UserKey> keys = new ConcurrentHashMap<>();
    // guarded by this
    private long trials;
    private long filledNanos;

    public OutletKeys(OutletStore store, Time time) {
        this.store = store;
        this.time = time;
        trials = TRIALS_PER_SECOND;
        filledNanos = time.nanos();
        store.keys().forEach(kept -> keys.put(kept.user(), UserKey.kept(kept, time.clock())));
    }

    public boolean has(String user) {
        return keys.containsKey(user);
    }

    /** Of a user; empty for one who has none. */
    public Optional<byte[]> dtlsSecret(String user) {
        return Optional.ofNullable(keys.get(user)).map(UserKey::dtlsSecret);
    }

    /** Whose key made this frame's signature; empty also when too much was tried lately. */
    public Optional<UserKey> owner(Frame frame) {
        List<UserKey> all = List.copyOf(keys.values());
        if (!frame.signed() || !mayTry(all.size())) {
            return Optional.empty();
        }
        return all.stream().filter(key -> key.signed(frame)).findFirst();
    }

    private synchronized boolean mayTry(int count) {
        long now = time.nanos();
        long elapsedMicros = Math.min(now - filledNanos, SECOND_NANOS) / 1_000;
        long earned = elapsedMicros * TRIALS_PER_SECOND / 1_000_000;
        if (earned > 0) {
            filledNanos = now;
            trials = Math.min(TRIALS_PER_SECOND, trials + earned);
        }
        if (trials <= 0) {
            return false;
        }
        trials -= Math.max(1, count);
        return true;
    }

    /** False when somebody else uses that very key: it would not tell them apart. */
    public synchronized boolean put(String user, LinkKey key) {
        boolean taken = store.keys().stream()
                .anyMatch(other -> !other.user().equals(user) && other.key().equals(key));
        if (taken) {
            return false;
        }
        store.saveKey(new OutletKey(user, key, 0));
        UserKey before = keys.put(user, UserKey.fresh(new OutletKey(user, key, 0), time.clock()));
        if (before != null) {
            before.withdraw();
        }
        return true;
    }

    /** False when there was none. */
    public synchronized boolean remove(String user) {
        boolean removed = store.deleteKey(user);
        drop(user);
        return removed;
    }

    /** The user is gone, and the stored key already. */
    void drop(String user) {
        UserKey before = keys.remove(user);
        if (before != null) {
            before.withdraw();
        }
    }

    /** Keeps how far the times of signatures have come, so that nothing is taken twice after a restart. */
    void storeStamps() {
        for (UserKey key : keys.values()) {
            long stamp = key.unstoredStamp();
            if (stamp > 0) {
                store.saveStamp(key.user(), stamp);
            }
        }
    }
}
