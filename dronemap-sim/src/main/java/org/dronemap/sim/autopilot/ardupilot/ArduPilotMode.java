package org.dronemap.sim.autopilot.ardupilot;

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
}
