package org.dronemap.sim.autopilot.ardupilot;

import org.dronemap.sim.physics.MotionSetpoint;

/** Moves a simulated ArduPilot vehicle as its present mode does. */
public interface ArduPilotFlight {
    ArduPilotMode mode();

    MotionSetpoint fly(long nowMillis);

    /** Parameters with speeds may have changed. */
    void readSpeeds();

    /** It has just been armed. */
    void armed();

    /** It has just been disarmed. */
    void disarmed();

    /** The throttle stick of the remote control, 1000 to 2000. */
    void setStick(int throttle);

    ArduPilotMission mission();
}
