package org.dronemap.sim.autopilot.ardupilot;

import static org.dronemap.sim.flight.SimulatedParameters.INT8;
import static org.dronemap.sim.flight.SimulatedParameters.REAL32;

import java.util.Comparator;
import java.util.List;
import org.dronemap.sim.autopilot.FenceStorage;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.physics.NeuPosition;

/** The rally points of a simulated ArduPilot vehicle, to which it returns instead of its home. Owned by its vehicle. */
public final class RallyPoints implements FenceStorage {
    private static final int RALLY_POINT = 5100;
    private static final double METERS = 1_000;

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private List<SimulatedMissionItem> held = List.of();

    RallyPoints(SimulatedCraft craft, SimulatedParameters parameters) {
        this.craft = craft;
        this.parameters = parameters;
    }

    /**
     * Adds the parameters that they heed.
     *
     * @param kilometers beyond which no point counts
     * @param withHome home counts where it is nearer than every point
     */
    public static SimulatedParameters withParameters(
            SimulatedParameters parameters, double kilometers, boolean withHome) {
        return parameters.add("RALLY_LIMIT_KM", REAL32, kilometers).add("RALLY_INCL_HOME", INT8, withHome ? 1 : 0);
    }

    @Override
    public int judge(SimulatedMissionItem item) {
        return item.command() == RALLY_POINT ? ACCEPTED : UNSUPPORTED;
    }

    @Override
    public int store(List<SimulatedMissionItem> items) {
        held = List.copyOf(items);
        return ACCEPTED;
    }

    @Override
    public List<SimulatedMissionItem> items() {
        return held;
    }

    /** The place that it returns to, height included: the nearest point, or {@code home} where that comes before it. */
    public NeuPosition orHome(NeuPosition home) {
        NeuPosition here = craft.body().position();
        return held.stream()
                .map(craft::targetOf)
                .min(Comparator.comparingDouble(here::horizontalDistanceTo))
                .filter(point -> comesBefore(here.horizontalDistanceTo(point), here.horizontalDistanceTo(home)))
                .orElse(home);
    }

    private boolean comesBefore(double toPoint, double toHome) {
        double limit = parameters.value("RALLY_LIMIT_KM") * METERS;
        boolean tooFar = limit > 0 && toPoint > limit;
        return !tooFar && (toPoint < toHome || parameters.value("RALLY_INCL_HOME") == 0);
    }
}
