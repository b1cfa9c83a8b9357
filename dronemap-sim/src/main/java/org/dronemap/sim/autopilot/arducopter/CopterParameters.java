package org.dronemap.sim.autopilot.arducopter;

import static org.dronemap.sim.flight.SimulatedParameters.INT16;
import static org.dronemap.sim.flight.SimulatedParameters.INT32;
import static org.dronemap.sim.flight.SimulatedParameters.INT8;
import static org.dronemap.sim.flight.SimulatedParameters.REAL32;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotParameters;
import org.dronemap.sim.autopilot.ardupilot.RallyPoints;
import org.dronemap.sim.flight.SimulatedParameters;

/** The parameters that the simulated ArduCopter heeds, with ArduCopter's defaults. */
final class CopterParameters {
    private CopterParameters() {}

    static SimulatedParameters defaults(int systemId, double batteryMilliampHours) {
        return RallyPoints.withParameters(ArduPilotParameters.shared(systemId, batteryMilliampHours), 0.3, true)
                .add("FS_GCS_ENABLE", INT8, 0)
                .add("FS_GCS_TIMEOUT", REAL32, 5)
                .add("FS_OPTIONS", INT32, 16)
                .add("FS_EKF_ACTION", INT8, 1)
                .add("DISARM_DELAY", INT8, 10)
                .add("RTL_ALT", INT32, 1500)
                .add("RTL_CONE_SLOPE", REAL32, 3)
                .add("RTL_LOIT_TIME", INT32, 5000)
                .add("WPNAV_SPEED", REAL32, 1000)
                .add("WPNAV_SPEED_UP", REAL32, 250)
                .add("WPNAV_SPEED_DN", REAL32, 150)
                .add("CIRCLE_RADIUS", REAL32, 1000)
                .add("CIRCLE_RATE", REAL32, 20)
                .add("LAND_SPEED", INT16, 50)
                .add("PILOT_SPEED_DN", INT16, 250)
                .add("PILOT_SPEED_UP", INT16, 250)
                .add("PILOT_Y_RATE", REAL32, 202.5)
                .add("LOIT_SPEED", REAL32, 1250)
                .add("SIM_ENGINE_FAIL", INT8, 0);
    }
}
