package org.dronemap.proxy.roslink;

import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.link.RobotKey;
import org.jspecify.annotations.Nullable;

/** Keys that were issued to the robots of a test; each is its own hash. */
final class TestRobotKeys implements RobotKeys {
    static final String OF_7 = "rk-of-seven";
    static final String OF_8 = "rk-of-eight";
    static final DroneId ROBOT_7 = new DroneId("drobot0007");
    static final DroneId ROBOT_8 = new DroneId("drobot0008");

    private final Map<String, RobotKey> keys = new ConcurrentHashMap<>();

    TestRobotKeys() {
        issue(OF_7, ROBOT_7, 7, "12");
        issue(OF_8, ROBOT_8, 8, "26");
    }

    void issue(String key, DroneId drone, int systemId, @Nullable String owner) {
        revoke(drone);
        keys.put(key, new RobotKey(drone, "robot", systemId, owner, key, "root", "root", Instant.EPOCH));
    }

    void revoke(DroneId drone) {
        keys.values().removeIf(key -> key.drone().equals(drone));
    }

    @Override
    public Optional<RobotKey> find(String key) {
        return Optional.ofNullable(keys.get(key));
    }

    @Override
    public boolean isOfIssuedForm(String key) {
        return key.startsWith("rk-");
    }

    @Override
    public boolean isValid(RobotKey key) {
        return keys.containsValue(key);
    }
}
