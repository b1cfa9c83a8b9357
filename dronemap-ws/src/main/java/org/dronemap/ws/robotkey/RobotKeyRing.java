package org.dronemap.ws.robotkey;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.link.RobotKey;
import org.dronemap.ws.reading.SecretGenerator;

/** The keys issued to ROSLink robots, stored as hashes and looked up by the key that a robot presents. Any thread. */
public final class RobotKeyRing {
    /** What all of them begin with, so that one which is not valid any more is told from a word of a robot's own. */
    private static final String BEGINNING = "rk-";

    private final EndpointStore store;
    private final Map<String, RobotKey> byHash = new ConcurrentHashMap<>();

    public RobotKeyRing(EndpointStore store) {
        this.store = store;
        store.robotKeys().forEach(key -> byHash.put(key.hash(), key));
    }

    /** Whose key that is; empty for one that was never issued, or is void. */
    public Optional<RobotKey> find(String key) {
        return isOfThisForm(key) ? Optional.ofNullable(byHash.get(SecretGenerator.hash(key))) : Optional.empty();
    }

    /** It can only be one that a server issued, valid or not. */
    public boolean isOfThisForm(String key) {
        return key.startsWith(BEGINNING);
    }

    /** It is the one that is valid for its drone now. */
    public boolean isValid(RobotKey key) {
        return key.equals(byHash.get(key.hash()));
    }

    static String fresh(SecretGenerator secrets) {
        return BEGINNING + secrets.token();
    }

    /** By the time they were made. */
    List<RobotKey> keys() {
        return store.robotKeys();
    }

    /** Returns once it is durable; the one of the same drone before is void. */
    synchronized void put(RobotKey key) {
        store.saveRobotKey(key);
        byHash.values().removeIf(before -> before.drone().equals(key.drone()));
        byHash.put(key.hash(), key);
    }

    /** True when there was one; void before it is forgotten for good. */
    synchronized boolean remove(DroneId drone) {
        byHash.values().removeIf(key -> key.drone().equals(drone));
        return store.deleteRobotKey(drone);
    }
}
