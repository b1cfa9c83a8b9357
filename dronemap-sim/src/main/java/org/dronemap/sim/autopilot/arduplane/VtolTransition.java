package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;

/** The progress of a simulated QuadPlane from its lift motors to its wings and back, with its texts about it. */
final class VtolTransition {
    private static final int TO_WINGS = 1;
    private static final int LIFTED = 3;
    private static final int ON_WINGS = 4;
    private static final double REACHED_SPEED = 18;
    private static final long SETTLING_MILLIS = 5_000;
    private static final long NEVER = -1;

    private final Consumer<FlightEvent> events;
    private int state = ON_WINGS;
    private long reachedAt = NEVER;

    VtolTransition(Consumer<FlightEvent> events) {
        this.events = events;
    }

    /** {@code lifted}: it is told to fly on its lift motors now. */
    void check(SimulatedCraft craft, boolean lifted, long nowMillis) {
        if (lifted) {
            state = LIFTED;
        } else if (craft.body().onGround()) {
            state = ON_WINGS;
        } else if (state == LIFTED) {
            state = TO_WINGS;
            reachedAt = NEVER;
            sendText("Transition started airspeed %.1f", craft.body().groundSpeed());
        } else if (state == TO_WINGS) {
            advance(craft.body().groundSpeed(), nowMillis);
        }
    }

    private void advance(double speed, long nowMillis) {
        if (reachedAt == NEVER && speed >= REACHED_SPEED) {
            reachedAt = nowMillis;
            sendText("Transition airspeed reached %.1f", speed);
        } else if (reachedAt != NEVER && nowMillis - reachedAt >= SETTLING_MILLIS) {
            state = ON_WINGS;
            sendText("Transition done");
        }
    }

    /** MAV_VTOL_STATE. */
    int state() {
        return state;
    }

    private void sendText(String format, Object... values) {
        events.accept(new FlightEvent.Text(TextSeverity.INFO, String.format(Locale.ROOT, format, values)));
    }
}
