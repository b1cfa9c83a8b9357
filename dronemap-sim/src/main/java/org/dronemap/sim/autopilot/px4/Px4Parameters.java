package org.dronemap.sim.autopilot.px4;

import static org.dronemap.sim.flight.SimulatedParameters.INT32;
import static org.dronemap.sim.flight.SimulatedParameters.REAL32;

import org.dronemap.sim.flight.SimulatedParameters;

/** The parameters that the simulated PX4 heeds, with PX4's defaults. */
final class Px4Parameters {
    private Px4Parameters() {}

    static SimulatedParameters defaults(int systemId) {
        return new SimulatedParameters()
                .add("MAV_SYS_ID", INT32, systemId)
                .add("MIS_TAKEOFF_ALT", REAL32, 2.5)
                .add("NAV_DLL_ACT", INT32, 0)
                .add("COM_DL_LOSS_T", INT32, 10)
                .add("COM_DLL_EXCEPT", INT32, 0)
                .add("COM_LOW_BAT_ACT", INT32, 0)
                .add("BAT_LOW_THR", REAL32, 0.15)
                .add("BAT_CRIT_THR", REAL32, 0.07)
                .add("BAT_EMERGEN_THR", REAL32, 0.05)
                .add("COM_DISARM_LAND", REAL32, 2)
                .add("COM_DISARM_PRFLT", REAL32, 10)
                .add("RTL_RETURN_ALT", REAL32, 60)
                .add("RTL_LAND_DELAY", REAL32, 0)
                .add("MPC_XY_CRUISE", REAL32, 5)
                .add("MPC_TKO_SPEED", REAL32, 1.5)
                .add("MPC_Z_V_AUTO_UP", REAL32, 3)
                .add("MPC_Z_V_AUTO_DN", REAL32, 1.5)
                .add("MPC_LAND_SPEED", REAL32, 0.7);
    }
}
