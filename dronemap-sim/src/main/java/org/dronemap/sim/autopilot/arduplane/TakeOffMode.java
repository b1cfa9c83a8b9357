package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.flight.Circle;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** The mode TAKEOFF of the simulated ArduPlane: up straight ahead, and then circles ahead of where it began. */
final class TakeOffMode implements Manoeuvre {
    private static final long FLYING_MILLIS = 10_000;

    private final SimulatedParameters parameters;
    private final CruiseSpeeds cruise;
    private final Consumer<FlightEvent> events;
    private final PlaneLaunch launch;
    private final FlyingEstimate estimate;
    private @Nullable NeuPosition start;
    private @Nullable Circle circle;

    TakeOffMode(
            SimulatedParameters parameters,
            CruiseSpeeds cruise,
            FlyingEstimate estimate,
            Consumer<FlightEvent> events) {
        this.parameters = parameters;
        this.cruise = cruise;
        this.events = events;
        this.launch = new PlaneLaunch(events);
        this.estimate = estimate;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (circle == null && start == null) {
            begin(craft, nowMillis);
        }
        if (circle != null) {
            return circle.fly(craft, nowMillis);
        }
        return start == null ? new MotionSetpoint.Glide() : climb(craft, start);
    }

    private void begin(SimulatedCraft craft, long nowMillis) {
        boolean flies = estimate.isFlying(craft.armed()) && estimate.flyingFor(nowMillis) > FLYING_MILLIS;
        if (flies) {
            circleFromTheAir(craft);
        } else if (launch.released(craft, nowMillis)) {
            start = craft.body().position();
            sendText(
                    "Takeoff to %.0fm for %.1fm heading %.1f deg",
                    parameters.value("TKOFF_ALT"),
                    parameters.value("TKOFF_DIST"),
                    Math.toDegrees(craft.body().yaw()));
        }
    }

    private void circleFromTheAir(SimulatedCraft craft) {
        NeuPosition here = craft.body().position();
        double missing = parameters.value("TKOFF_ALT") - craft.aboveHome();
        if (missing <= 0) {
            sendText("Above TKOFF alt - loitering");
            circle = around(here);
        } else {
            sendText("Climbing to TKOFF alt then loitering");
            circle = around(ahead(here, craft.body().yaw()).withUp(here.up() + missing));
        }
    }

    private MotionSetpoint climb(SimulatedCraft craft, NeuPosition begun) {
        NeuPosition here = craft.body().position();
        boolean clear = here.up() - begun.up() >= parameters.value("TKOFF_LVL_ALT")
                || here.horizontalDistanceTo(begun) >= parameters.value("TKOFF_DIST");
        if (clear) {
            circle = around(ahead(begun, begun.bearingTo(here)).withUp(begun.up() + parameters.value("TKOFF_ALT")));
        }
        return ClimbOut.setpoint();
    }

    private NeuPosition ahead(NeuPosition from, double bearing) {
        double meters = parameters.value("TKOFF_DIST");
        return new NeuPosition(
                from.north() + meters * Math.cos(bearing), from.east() + meters * Math.sin(bearing), from.up());
    }

    private Circle around(NeuPosition centre) {
        return new Circle(centre, parameters.value("WP_LOITER_RAD"), cruise);
    }

    private void sendText(String format, Object... values) {
        events.accept(new FlightEvent.Text(TextSeverity.INFO, String.format(Locale.ROOT, format, values)));
    }
}
