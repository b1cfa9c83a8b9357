package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;

/** The start of a take-off of the simulated ArduPlane: no power before it is armed and has waited a moment. */
final class PlaneLaunch {
    private static final long WAIT_MILLIS = 200;
    private static final long SPOOL_MILLIS = 500;

    private final Consumer<FlightEvent> events;
    private long armedAt = -1;
    private boolean triggered;
    private boolean released;

    PlaneLaunch(Consumer<FlightEvent> events) {
        this.events = events;
    }

    /** One that flies already needs no start. */
    void release() {
        released = true;
    }

    /** True once it may use its power. */
    boolean released(SimulatedCraft craft, long nowMillis) {
        if (!craft.armed()) {
            armedAt = -1;
            return released;
        }
        if (armedAt < 0 && !released) {
            armedAt = nowMillis;
            triggered = false;
            sendText("Armed AUTO, xaccel = 0.0 m/s/s, waiting 0.2 sec");
        }
        if (!released && !triggered && nowMillis - armedAt >= WAIT_MILLIS) {
            triggered = true;
            sendText(String.format(
                    Locale.ROOT,
                    "Triggered AUTO. GPS speed = %.1f",
                    craft.body().groundSpeed()));
        }
        released |= triggered && nowMillis - armedAt >= WAIT_MILLIS + SPOOL_MILLIS;
        return released;
    }

    private void sendText(String text) {
        events.accept(new FlightEvent.Text(TextSeverity.INFO, text));
    }
}
