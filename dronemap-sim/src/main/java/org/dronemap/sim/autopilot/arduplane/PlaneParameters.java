package org.dronemap.sim.autopilot.arduplane;

import static org.dronemap.sim.flight.SimulatedParameters.INT16;
import static org.dronemap.sim.flight.SimulatedParameters.INT8;
import static org.dronemap.sim.flight.SimulatedParameters.REAL32;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotParameters;
import org.dronemap.sim.autopilot.ardupilot.RallyPoints;
import org.dronemap.sim.flight.SimulatedParameters;

/** The parameters that the simulated ArduPlane heeds, with the values of the aeroplane that was recorded. */
final class PlaneParameters {
    private static final int FENCE_OF_SHAPES = 4;

    private PlaneParameters() {}

    static SimulatedParameters defaults(int systemId, double batteryMilliampHours, boolean lifts) {
        SimulatedParameters table = RallyPoints.withParameters(
                        ArduPilotParameters.shared(systemId, batteryMilliampHours), 5, false)
                .add("FS_GCS_ENABL", INT8, 0)
                .add("FS_LONG_ACTN", INT8, 0)
                .add("FS_LONG_TIMEOUT", REAL32, 5)
                .add("RTL_ALTITUDE", REAL32, lifts ? 20 : 100)
                .add("RTL_RADIUS", INT16, 0)
                .add("RTL_AUTOLAND", INT8, 0)
                .add("AIRSPEED_CRUISE", REAL32, lifts ? 25 : 22)
                .add("AIRSPEED_MIN", INT16, lifts ? 13 : 10)
                .add("AIRSPEED_MAX", INT16, lifts ? 35 : 30)
                .add("WP_RADIUS", INT16, lifts ? 90 : 50)
                .add("WP_LOITER_RAD", INT16, lifts ? 60 : 80)
                .add("TECS_CLMB_MAX", REAL32, 5)
                .add("TECS_SINK_MAX", REAL32, 5)
                .add("TKOFF_ALT", REAL32, 50)
                .add("TKOFF_DIST", REAL32, 200)
                .add("TKOFF_LVL_ALT", REAL32, 5)
                .add("LAND_FLARE_ALT", REAL32, 3)
                .add("LAND_FLARE_SEC", REAL32, lifts ? 2 : 3)
                .add("LAND_DISARMDELAY", INT8, 20)
                .add("Q_ENABLE", INT8, lifts ? 1 : 0);
        table.set("FENCE_TYPE", FENCE_OF_SHAPES);
        if (lifts) {
            table.add("Q_RTL_ALT", INT16, 15)
                    .add("Q_RTL_MODE", INT8, 0)
                    .add("Q_LAND_FINAL_SPD", REAL32, 0.5)
                    .add("Q_LAND_FINAL_ALT", REAL32, 6);
        }
        return table;
    }
}
