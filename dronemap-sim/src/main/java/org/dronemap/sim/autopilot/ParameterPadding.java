package org.dronemap.sim.autopilot;

import java.util.Locale;
import org.dronemap.sim.flight.SimulatedParameters;

/** Fills up a simulated vehicle's parameter table with unused ones to the size of a real autopilot's. */
final class ParameterPadding {
    private static final int[] WHOLE_TYPES_OF_ARDUPILOT = {
        SimulatedParameters.INT8, SimulatedParameters.INT16, SimulatedParameters.INT32
    };
    private static final int[] WHOLE_TYPES_OF_PX4 = {SimulatedParameters.INT32};

    private ParameterPadding() {}

    static void pad(SimulatedParameters parameters, int size, boolean onlyLargeTypes) {
        int[] wholeTypes = onlyLargeTypes ? WHOLE_TYPES_OF_PX4 : WHOLE_TYPES_OF_ARDUPILOT;
        for (int number = 0; parameters.size() < size; number++) {
            boolean decimal = number % 2 == 0;
            int type = decimal ? SimulatedParameters.REAL32 : wholeTypes[number / 2 % wholeTypes.length];
            double value = decimal ? (float) (number * 0.1) : number % 100;
            parameters.add(String.format(Locale.ROOT, "SPARE_%04d", number), type, value);
        }
    }
}
