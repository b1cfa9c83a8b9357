package org.dronemap.sim.autopilot.fence;

import static org.dronemap.sim.flight.SimulatedParameters.INT8;
import static org.dronemap.sim.flight.SimulatedParameters.REAL32;

import java.util.List;
import java.util.function.Consumer;
import org.dronemap.mavlink.message.FenceStatus;
import org.dronemap.sim.autopilot.FenceStorage;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.NeuPosition;

/**
 * The fence of a simulated ArduPilot vehicle: a greatest height, a circle around home, and the shapes that were
 * uploaded. Metres. Owned by its vehicle.
 */
public final class SimulatedFence implements FenceStorage {
    private static final int ALTITUDE = 1;
    private static final int CIRCLE = 2;
    private static final int SHAPES = 4;
    private static final int ALL = ALTITUDE | CIRCLE | SHAPES;
    /** Farther out by so much, and it is a breach anew. */
    private static final double AGAIN_METERS = 20;

    private static final int TOLD_NONE = 0;
    private static final int TOLD_ALTITUDE = 2;
    private static final int TOLD_BOUNDARY = 3;

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final Consumer<FlightEvent> events;
    private List<SimulatedMissionItem> items = List.of();
    private List<FenceShape> shapes = List.of();
    private int breached;
    private int breaches;
    private int told = TOLD_NONE;
    private long breachedAt;
    private double againAt;

    public SimulatedFence(SimulatedCraft craft, SimulatedParameters parameters, Consumer<FlightEvent> events) {
        this.craft = craft;
        this.parameters = parameters;
        this.events = events;
    }

    /** Adds the parameters that it heeds, with Copter's defaults. */
    public static SimulatedParameters withParameters(SimulatedParameters parameters) {
        return parameters
                .add("FENCE_ENABLE", INT8, 0)
                .add("FENCE_TYPE", INT8, ALL)
                .add("FENCE_ACTION", INT8, 1)
                .add("FENCE_ALT_MAX", REAL32, 100)
                .add("FENCE_RADIUS", REAL32, 300)
                .add("FENCE_TOTAL", INT8, 0);
    }

    @Override
    public int judge(SimulatedMissionItem item) {
        return FenceItems.isKnown(item.command()) ? ACCEPTED : UNSUPPORTED;
    }

    @Override
    public int store(List<SimulatedMissionItem> newItems) {
        FenceItems read = new FenceItems(craft.frame(), newItems);
        if (!read.complaint().isEmpty()) {
            sendText(TextSeverity.WARNING, read.complaint());
            sendText(TextSeverity.WARNING, "Fence validation failed");
            return ERROR;
        }
        items = List.copyOf(newItems);
        shapes = read.shapes();
        parameters.set("FENCE_TOTAL", items.size());
        sendText(TextSeverity.DEBUG, "Fence Indexed OK");
        return ACCEPTED;
    }

    private void sendText(TextSeverity severity, String text) {
        events.accept(new FlightEvent.Text(severity, text));
    }

    @Override
    public List<SimulatedMissionItem> items() {
        return items;
    }

    public boolean enabled() {
        return parameters.value("FENCE_ENABLE") != 0;
    }

    private boolean has(int type) {
        return ((int) parameters.value("FENCE_TYPE") & type) != 0;
    }

    private boolean hasShapes() {
        return has(SHAPES) && !shapes.isEmpty();
    }

    private boolean isPresent() {
        return has(ALTITUDE | CIRCLE) || hasShapes();
    }

    /** Switches it on or off; false when there is nothing to switch on. */
    public boolean enable(boolean on) {
        if (on && !isPresent()) {
            return false;
        }
        parameters.set("FENCE_ENABLE", on ? 1 : 0);
        return true;
    }

    /** What keeps the vehicle from arming; empty when nothing does. */
    public String complaint() {
        if (!enabled()) {
            return "";
        }
        if (!isPresent()) {
            return "Fences enabled, but none selected";
        }
        if (has(CIRCLE | SHAPES) && !craft.navigation().hasEstimate()) {
            return "Fence requires position";
        }
        return breached == 0 ? "" : "vehicle outside fence";
    }

    /** False for a place that it must not fly to. */
    public boolean allows(NeuPosition place) {
        return !enabled() || outside(place) == 0;
    }

    private int outside(NeuPosition place) {
        int mask = 0;
        if (has(ALTITUDE) && aboveHome(place) >= parameters.value("FENCE_ALT_MAX")) {
            mask |= ALTITUDE;
        }
        if (has(CIRCLE) && fromHome(place) >= parameters.value("FENCE_RADIUS")) {
            mask |= CIRCLE;
        }
        if (hasShapes() && shapes.stream().anyMatch(shape -> !shape.allows(place))) {
            mask |= SHAPES;
        }
        return mask;
    }

    private double aboveHome(NeuPosition place) {
        return place.up() - craft.homePosition().up();
    }

    private double fromHome(NeuPosition place) {
        return place.horizontalDistanceTo(craft.homePosition());
    }

    /** Looks where the vehicle is; true when it has just left its fence, or got farther out. */
    public boolean check(long nowMillis) {
        NeuPosition here = craft.body().position();
        int mask = enabled() && craft.navigation().hasEstimate() ? outside(here) : 0;
        boolean farther = mask != 0 && breached != 0 && metersOutside() >= againAt;
        boolean left = (mask & ~breached) != 0 || farther;
        if (left) {
            breaches++;
            breachedAt = nowMillis;
            againAt = metersOutside() + AGAIN_METERS;
            told = (mask & (CIRCLE | SHAPES)) != 0 ? TOLD_BOUNDARY : TOLD_ALTITUDE;
        }
        breached = mask;
        return left;
    }

    /** How far it is beyond its height and its circle; of shapes it is not known. */
    public double metersOutside() {
        NeuPosition here = craft.body().position();
        double high = has(ALTITUDE) ? aboveHome(here) - parameters.value("FENCE_ALT_MAX") : 0;
        double far = has(CIRCLE) ? fromHome(here) - parameters.value("FENCE_RADIUS") : 0;
        return Math.max(0, Math.max(high, far));
    }

    public boolean breached() {
        return breached != 0;
    }

    public FenceStatus status() {
        return new FenceStatus(breached == 0 ? 0 : 1, breaches, breached == 0 ? TOLD_NONE : told, breachedAt, 0);
    }
}
