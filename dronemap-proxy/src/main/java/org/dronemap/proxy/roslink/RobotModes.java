package org.dronemap.proxy.roslink;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.Capabilities.Steering;
import org.jspecify.annotations.Nullable;

/** The flight modes that a ROSLink bridge to mavros can set, by number; any other number makes the bridge fail. */
final class RobotModes {
    static final int GUIDED = 4;
    static final int RETURN = 6;

    private static final Map<Integer, String> NAMES = names();
    private static final Map<String, Steering> STEERING = Map.of(
            "STABILIZE", Steering.STICKS,
            "ALT_HOLD", Steering.STICKS,
            "AUTO", Steering.MISSION,
            "GUIDED", Steering.ORDERS,
            "LOITER", Steering.STICKS,
            "RTL", Steering.HOME,
            "LAND", Steering.SAFETY);

    private RobotModes() {}

    private static Map<Integer, String> names() {
        Map<Integer, String> names = new LinkedHashMap<>();
        names.put(0, "STABILIZE");
        names.put(2, "ALT_HOLD");
        names.put(3, "AUTO");
        names.put(GUIDED, "GUIDED");
        names.put(5, "LOITER");
        names.put(RETURN, "RTL");
        names.put(9, "LAND");
        return names;
    }

    static List<String> all() {
        return List.copyOf(NAMES.values());
    }

    static Map<String, Steering> steering() {
        return STEERING;
    }

    /** Of several for the same, the one that a robot is put into. */
    static Map<Steering, String> usual() {
        return Map.of(Steering.STICKS, "LOITER");
    }

    /** Null for a mode that has no name here. */
    static @Nullable String name(int number) {
        return NAMES.get(number);
    }

    /** Null for a name that is none. */
    static @Nullable Integer number(String name) {
        return NAMES.entrySet().stream()
                .filter(mode -> mode.getValue().equals(name))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(null);
    }
}
