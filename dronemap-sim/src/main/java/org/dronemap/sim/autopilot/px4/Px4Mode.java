package org.dronemap.sim.autopilot.px4;

import org.jspecify.annotations.Nullable;

/** The flight modes of the simulated PX4: main mode in the third byte of custom_mode, sub mode in the fourth. */
enum Px4Mode {
    MANUAL(1, 0, false, "Manual"),
    ALTITUDE(2, 0, false, "Altitude"),
    POSITION(3, 0, true, "Position"),
    TAKEOFF(4, 2, true, "Takeoff"),
    HOLD(4, 3, true, "Hold"),
    MISSION(4, 4, true, "Mission"),
    RETURN(4, 5, true, "Return"),
    LAND(4, 6, false, "Land"),
    ACRO(5, 0, false, "Acro"),
    OFFBOARD(6, 0, true, "Offboard"),
    STABILIZED(7, 0, false, "Stabilized");

    final int main;
    final int sub;
    final boolean needsPosition;
    final String label;

    Px4Mode(int main, int sub, boolean needsPosition, String label) {
        this.main = main;
        this.sub = sub;
        this.needsPosition = needsPosition;
        this.label = label;
    }

    static @Nullable Px4Mode of(int main, int sub) {
        for (Px4Mode mode : values()) {
            if (mode.main == main && mode.sub == sub) {
                return mode;
            }
        }
        return null;
    }

    long customMode() {
        return (long) main << 16 | (long) sub << 24;
    }

    int baseMode() {
        return switch (main) {
            case 4 -> 1 | 4 | 8 | 16;
            case 6 -> 1 | 8 | 16;
            case 1 -> 1 | 64;
            default -> 1 | 16 | 64;
        };
    }
}
