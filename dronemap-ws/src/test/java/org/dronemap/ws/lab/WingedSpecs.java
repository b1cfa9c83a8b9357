package org.dronemap.ws.lab;

import java.util.Map;
import org.dronemap.sim.autopilot.AutopilotKind;
import org.dronemap.sim.autopilot.arduplane.SimulatedArduPlane;
import org.dronemap.sim.physics.FixedWingBody;
import org.dronemap.sim.physics.QuadPlaneBody;

/** What the winged vehicles of the laboratory are made of. */
public final class WingedSpecs {
    private static final String BANNER = "\n\nInit ArduPlane V4.5.6 (simulated)\n\n";

    public static final VehicleSpec PLANE =
            spec(new AutopilotKind("arduplane", BANNER, () -> new FixedWingBody(0), SimulatedArduPlane::new));
    public static final VehicleSpec QUADPLANE =
            spec(new AutopilotKind("quadplane", BANNER, () -> new QuadPlaneBody(0), SimulatedArduPlane::quadPlane));

    private WingedSpecs() {}

    private static VehicleSpec spec(AutopilotKind kind) {
        return new VehicleSpec(kind, 2, 0, 1, 0, Map.of(), true, false);
    }
}
