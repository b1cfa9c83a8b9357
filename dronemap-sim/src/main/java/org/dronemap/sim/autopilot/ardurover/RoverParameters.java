package org.dronemap.sim.autopilot.ardurover;

import static org.dronemap.sim.flight.SimulatedParameters.INT32;
import static org.dronemap.sim.flight.SimulatedParameters.INT8;
import static org.dronemap.sim.flight.SimulatedParameters.REAL32;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotParameters;
import org.dronemap.sim.autopilot.ardupilot.RallyPoints;
import org.dronemap.sim.flight.SimulatedParameters;

/** The parameters that the simulated ArduRover heeds, with ArduRover's defaults. */
final class RoverParameters {
    private static final int FENCE_WITHOUT_HEIGHT = 6;

    private RoverParameters() {}

    static SimulatedParameters defaults(int systemId, double batteryMilliampHours) {
        SimulatedParameters table = RallyPoints.withParameters(
                        ArduPilotParameters.shared(systemId, batteryMilliampHours), 0.5, true)
                .add("FS_ACTION", INT8, 2)
                .add("FS_TIMEOUT", REAL32, 1.5)
                .add("FS_THR_ENABLE", INT8, 1)
                .add("FS_GCS_ENABLE", INT8, 0)
                .add("FS_GCS_TIMEOUT", REAL32, 5)
                .add("FS_OPTIONS", INT32, 0)
                .add("FS_EKF_ACTION", INT8, 1)
                .add("FS_CRASH_CHECK", INT8, 0)
                .add("FRAME_CLASS", INT8, 1)
                .add("MIS_DONE_BEHAVE", INT8, 0)
                .add("CRUISE_SPEED", REAL32, 5)
                .add("WP_SPEED", REAL32, 5)
                .add("WP_RADIUS", REAL32, 3)
                .add("RTL_SPEED", REAL32, 0)
                .add("LOIT_RADIUS", REAL32, 2);
        table.set("FENCE_TYPE", FENCE_WITHOUT_HEIGHT);
        return table;
    }
}
