package org.dronemap.sim.autopilot.ardupilot;

import org.jspecify.annotations.Nullable;

/** A mode of a simulated ArduPilot vehicle; each vehicle has an enum of its own with ArduPilot's names. */
public interface ArduPilotMode {
    /** ArduPilot's name, as its sentences have it. */
    String name();

    /** The custom_mode of the heartbeat. */
    int number();

    boolean needsPosition();

    /** It flies the stored mission, and is not armed without one. */
    boolean needsMission();

    boolean armable();

    /** The one of a vehicle's modes with that number; null when it has none. */
    static <M extends ArduPilotMode> @Nullable M withNumber(M[] modes, long number) {
        for (M mode : modes) {
            if (mode.number() == number) {
                return mode;
            }
        }
        return null;
    }
}
