package org.dronemap.proxy.mavlink.translate;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.drone.Capabilities.Steering;
import org.jspecify.annotations.Nullable;

/**
 * The flight modes of one ArduPilot vehicle type: the number in custom_mode and the name, in both directions.
 * Immutable.
 */
final class ArduPilotModeTable {
    static final ArduPilotModeTable EMPTY = new ArduPilotModeTable(Map.of());

    static final ArduPilotModeTable COPTER =
            parse("0 STABILIZE, 1 ACRO, 2 ALT_HOLD, 3 AUTO, 4 GUIDED, 5 LOITER, 6 RTL, 7 CIRCLE, 8 POSITION, 9 LAND,"
                    + " 10 OF_LOITER, 11 DRIFT, 13 SPORT, 14 FLIP, 15 AUTOTUNE, 16 POSHOLD, 17 BRAKE, 18 THROW,"
                    + " 19 AVOID_ADSB, 20 GUIDED_NOGPS, 21 SMART_RTL, 22 FLOWHOLD, 23 FOLLOW, 24 ZIGZAG, 25 SYSTEMID,"
                    + " 26 AUTOROTATE, 27 AUTO_RTL, 28 TURTLE, 29 RATE_ACRO");
    static final ArduPilotModeTable PLANE =
            parse("0 MANUAL, 1 CIRCLE, 2 STABILIZE, 3 TRAINING, 4 ACRO, 5 FBWA, 6 FBWB, 7 CRUISE, 8 AUTOTUNE, 10 AUTO,"
                    + " 11 RTL, 12 LOITER, 13 TAKEOFF, 14 AVOID_ADSB, 15 GUIDED, 16 INITIALISING, 17 QSTABILIZE,"
                    + " 18 QHOVER, 19 QLOITER, 20 QLAND, 21 QRTL, 22 QAUTOTUNE, 23 QACRO, 24 THERMAL,"
                    + " 25 LOITERALTQLAND, 26 AUTOLAND");
    static final ArduPilotModeTable ROVER =
            parse("0 MANUAL, 1 ACRO, 2 LEARNING, 3 STEERING, 4 HOLD, 5 LOITER, 6 FOLLOW, 7 SIMPLE, 8 DOCK, 9 CIRCLE,"
                    + " 10 AUTO, 11 RTL, 12 SMART_RTL, 15 GUIDED, 16 INITIALISING");
    static final ArduPilotModeTable SUB =
            parse("0 STABILIZE, 1 ACRO, 2 ALT_HOLD, 3 AUTO, 4 GUIDED, 7 CIRCLE, 9 SURFACE, 16 POSHOLD, 19 MANUAL");
    static final ArduPilotModeTable BLIMP = parse("0 LAND, 1 MANUAL, 2 VELOCITY, 3 LOITER, 4 RTL, 5 AUTO, 6 HOLD");

    /** Modes of a pilot's sticks, of whichever firmware. */
    private static final Set<String> STICKS = Set.of(
            "STABILIZE",
            "ACRO",
            "ALT_HOLD",
            "POSITION",
            "OF_LOITER",
            "DRIFT",
            "SPORT",
            "FLIP",
            "AUTOTUNE",
            "POSHOLD",
            "FLOWHOLD",
            "ZIGZAG",
            "TURTLE",
            "RATE_ACRO",
            "MANUAL",
            "TRAINING",
            "FBWA",
            "FBWB",
            "CRUISE",
            "QSTABILIZE",
            "QHOVER",
            "QLOITER",
            "QAUTOTUNE",
            "QACRO",
            "LEARNING",
            "STEERING",
            "SIMPLE",
            "VELOCITY");

    private static final Set<String> HOME = Set.of("RTL", "SMART_RTL", "AUTO_RTL", "QRTL");

    private static final Set<String> SAFETY = Set.of("LAND", "QLAND", "AUTOLAND", "LOITERALTQLAND");

    /** The first of these that a vehicle has is the one for what it goes by in it. */
    private static final List<String> USUAL = List.of("GUIDED", "LOITER", "AUTO", "RTL", "LAND");

    private static final String GUIDED = "GUIDED";

    private static final Set<String> ORDERS = Set.of(GUIDED, "GUIDED_NOGPS");

    /** Mode::allows_arming of ArduCopter 4.5; AUTO unless AUTO_OPTIONS allows it. */
    private static final Set<String> COPTER_REFUSES_TO_ARM =
            Set.of("AUTO", "RTL", "CIRCLE", "LAND", "FLIP", "AUTOTUNE", "BRAKE", "AVOID_ADSB", "SMART_RTL", "AUTO_RTL");

    private static final Set<String> STANDS = Set.of("BRAKE", "HOLD");

    private final Map<Long, String> names;

    private ArduPilotModeTable(Map<Long, String> names) {
        this.names = names;
    }

    private static ArduPilotModeTable parse(String pairs) {
        Map<Long, String> names = new LinkedHashMap<>();
        for (String pair : pairs.split(", ", -1)) {
            String[] parts = pair.split(" ", 2);
            names.put(Long.parseLong(parts[0]), parts[1]);
        }
        return new ArduPilotModeTable(names);
    }

    @Nullable
    String name(long number) {
        return names.get(number);
    }

    Optional<Long> number(String name) {
        return names.entrySet().stream()
                .filter(entry -> entry.getValue().equals(name))
                .map(Map.Entry::getKey)
                .findFirst();
    }

    List<String> names() {
        return List.copyOf(names.values());
    }

    /** What the vehicle goes by in each mode, where it is known. */
    Map<String, Steering> steering() {
        Map<String, Steering> steering = new LinkedHashMap<>();
        for (String name : names.values()) {
            // A plane circles in LOITER; everything else is steered in it.
            boolean loiter = name.equals("LOITER");
            if (STICKS.contains(name) || (loiter && this != PLANE)) {
                steering.put(name, Steering.STICKS);
            } else if (ORDERS.contains(name) || loiter) {
                steering.put(name, Steering.ORDERS);
            } else if (STANDS.contains(name)) {
                steering.put(name, Steering.STANDS);
            } else if (HOME.contains(name)) {
                steering.put(name, Steering.HOME);
            } else if (SAFETY.contains(name)) {
                steering.put(name, Steering.SAFETY);
            } else if (name.equals("AUTO")) {
                steering.put(name, Steering.MISSION);
            }
        }
        return steering;
    }

    /** For each mode in which the vehicle refuses to be armed, the one in which it is armed and waits for orders. */
    Map<String, String> arming() {
        Map<String, String> arming = new LinkedHashMap<>();
        if (has(GUIDED)) {
            names.values().stream().filter(this::refusesToArm).forEach(name -> arming.put(name, GUIDED));
        }
        return arming;
    }

    private boolean refusesToArm(String mode) {
        return this == COPTER ? COPTER_REFUSES_TO_ARM.contains(mode) : HOME.contains(mode) || SAFETY.contains(mode);
    }

    /** The mode that it is put into for each of these, where there are several. */
    Map<Steering, String> usual() {
        Map<Steering, String> usual = new EnumMap<>(Steering.class);
        Map<String, Steering> steering = steering();
        for (String name : USUAL) {
            Optional.ofNullable(steering.get(name)).ifPresent(by -> usual.putIfAbsent(by, name));
        }
        return usual;
    }

    boolean has(String name) {
        return names.containsValue(name);
    }
}
