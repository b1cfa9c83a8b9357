package org.dronemap.sim.autopilot.ardupilot;

import static org.dronemap.sim.flight.SimulatedParameters.INT16;
import static org.dronemap.sim.flight.SimulatedParameters.INT32;
import static org.dronemap.sim.flight.SimulatedParameters.INT8;
import static org.dronemap.sim.flight.SimulatedParameters.REAL32;

import org.dronemap.sim.autopilot.fence.SimulatedFence;
import org.dronemap.sim.flight.SimulatedParameters;

/** The parameters that every simulated ArduPilot vehicle has, with ArduPilot's defaults. */
public final class ArduPilotParameters {
    private ArduPilotParameters() {}

    /** A new table, to which each vehicle adds its own. */
    public static SimulatedParameters shared(int systemId, double batteryMilliampHours) {
        return SimulatedFence.withParameters(secondBattery(new SimulatedParameters()))
                .add("SYSID_THISMAV", INT16, systemId)
                .add("SYSID_MYGCS", INT16, 255)
                .add("BATT_MONITOR", INT8, 4)
                .add("BATT_CAPACITY", INT32, batteryMilliampHours)
                .add("BATT_LOW_TIMER", INT8, 10)
                .add("BATT_LOW_VOLT", REAL32, 10.5)
                .add("BATT_LOW_MAH", REAL32, 0)
                .add("BATT_CRT_VOLT", REAL32, 0)
                .add("BATT_CRT_MAH", REAL32, 0)
                .add("BATT_FS_LOW_ACT", INT8, 0)
                .add("BATT_FS_CRT_ACT", INT8, 0)
                .add("ARMING_CHECK", INT32, 1)
                .add("MNT1_TYPE", INT8, 0)
                .add("SIM_BATT_VOLTAGE", REAL32, 0)
                .add("SIM_GPS_DISABLE", INT8, 0)
                .add("SIM_ENGINE_MUL", REAL32, 1);
    }

    /** Without a monitor there is no second battery. */
    private static SimulatedParameters secondBattery(SimulatedParameters parameters) {
        return parameters
                .add("BATT2_MONITOR", INT8, 0)
                .add("BATT2_CAPACITY", INT32, 3300)
                .add("BATT2_LOW_TIMER", INT8, 10)
                .add("BATT2_LOW_VOLT", REAL32, 10.5)
                .add("BATT2_LOW_MAH", REAL32, 0)
                .add("BATT2_CRT_VOLT", REAL32, 0)
                .add("BATT2_CRT_MAH", REAL32, 0)
                .add("BATT2_FS_LOW_ACT", INT8, 0)
                .add("BATT2_FS_CRT_ACT", INT8, 0);
    }
}
