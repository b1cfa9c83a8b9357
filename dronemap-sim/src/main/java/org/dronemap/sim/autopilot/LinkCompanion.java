package org.dronemap.sim.autopilot;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dronemap.mavlink.message.Heartbeat;

/** Another sender that may speak on the link of a simulated vehicle, with a heartbeat of its own. */
public enum LinkCompanion {
    GIMBAL(154, 26, false),
    CAMERA(100, 30, false),
    COMPUTER(191, 18, false),
    ADSB(156, 27, false),
    STATION(190, 6, true);

    private static final int NO_AUTOPILOT = 8;
    private static final int ACTIVE = 4;
    private static final int STATION_SYSTEM = 255;

    private final int component;
    private final int type;
    private final boolean ownSystem;

    LinkCompanion(int component, int type, boolean ownSystem) {
        this.component = component;
        this.type = type;
        this.ownSystem = ownSystem;
    }

    /** {@code names} with commas between them; nothing for nobody. */
    public static List<LinkCompanion> named(String names) {
        if (names.isBlank()) {
            return List.of();
        }
        return Arrays.stream(names.split(",", -1)).map(LinkCompanion::of).toList();
    }

    private static LinkCompanion of(String name) {
        for (LinkCompanion companion : values()) {
            if (companion.name().equalsIgnoreCase(name.trim())) {
                return companion;
            }
        }
        String all = Arrays.stream(values())
                .map(companion -> companion.name().toLowerCase(Locale.ROOT))
                .collect(Collectors.joining(", "));
        throw new IllegalArgumentException("no companion is called '" + name.trim() + "'; there are " + all);
    }

    int component() {
        return component;
    }

    int system(int vehicle) {
        return ownSystem ? STATION_SYSTEM : vehicle;
    }

    Heartbeat heartbeat() {
        return new Heartbeat(type, NO_AUTOPILOT, 0, 0, ACTIVE, 3);
    }
}
