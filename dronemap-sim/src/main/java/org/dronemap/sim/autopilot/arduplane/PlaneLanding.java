package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.flight.WingGuidance;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/**
 * The landing item of a simulated ArduPlane's mission: down a slope from where it begins, without power from the flare
 * on. It never ends by itself, and can be broken off before the flare.
 */
final class PlaneLanding implements Manoeuvre {
    private static final long SLOPE_MILLIS = 500;
    private static final double SHORTEST_METERS = 1;
    /** It aims before its place, for what it floats on after the flare, and begins to sink before it should be lower. */
    private static final double FLOATS_METERS = 30;

    private static final double LOOKS_AHEAD_SECONDS = 4;

    private enum Stage {
        APPROACH,
        CLIMBING_AWAY,
        FLARED
    }

    private final NeuPosition from;
    private final NeuPosition to;
    private final SimulatedParameters parameters;
    private final WingGuidance guidance;
    private final Consumer<FlightEvent> events;
    private Stage stage = Stage.APPROACH;
    private long begunAt = -1;
    private boolean slopeReported;
    private double climbTo;
    private boolean climbedAway;

    PlaneLanding(NeuPosition from, NeuPosition to, SimulatedParameters parameters, Consumer<FlightEvent> events) {
        this.from = from;
        this.to = to;
        this.parameters = parameters;
        this.events = events;
        double speed = (parameters.value("AIRSPEED_MIN") + parameters.value("AIRSPEED_CRUISE")) / 2;
        this.guidance = new WingGuidance(
                new CruiseSpeeds(speed, parameters.value("TECS_CLMB_MAX"), parameters.value("TECS_SINK_MAX"), 1));
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (begunAt < 0) {
            begunAt = nowMillis;
            sendText(TextSeverity.INFO, "Landing approach start at %.1fm", craft.aboveHome());
        }
        if (stage == Stage.CLIMBING_AWAY) {
            climbedAway |= craft.aboveHome() > climbTo;
            return ClimbOut.setpoint();
        }
        if (stage == Stage.FLARED || flares(craft)) {
            return new MotionSetpoint.Glide();
        }
        reportSlope(nowMillis);
        return guidance.along(craft.body(), from, to, slopeHeight(craft));
    }

    private void reportSlope(long nowMillis) {
        if (!slopeReported && nowMillis - begunAt >= SLOPE_MILLIS) {
            slopeReported = true;
            double slope = Math.toDegrees(Math.atan2(from.up() - to.up(), from.horizontalDistanceTo(to)));
            sendText(TextSeverity.INFO, "Landing glide slope %.1f degrees", slope);
        }
    }

    private double slopeHeight(SimulatedCraft craft) {
        double ahead = craft.body().groundSpeed() * LOOKS_AHEAD_SECONDS + FLOATS_METERS;
        double share = share(craft.body().position()) + ahead / from.horizontalDistanceTo(to);
        return from.up() + (to.up() - from.up()) * Math.max(0, Math.min(1, share));
    }

    /** Share of the way from where the landing began; 1 at once when there is no way. */
    private double share(NeuPosition here) {
        double length = from.horizontalDistanceTo(to);
        if (length < SHORTEST_METERS) {
            return 1;
        }
        double line = from.bearingTo(to);
        double gone = (here.north() - from.north()) * Math.cos(line) + (here.east() - from.east()) * Math.sin(line);
        return gone / length;
    }

    private boolean flares(SimulatedCraft craft) {
        double height = craft.body().up() - to.up();
        double sink = -craft.body().velocityUp();
        double share = share(craft.body().position());
        boolean low = height <= parameters.value("LAND_FLARE_ALT")
                || (height <= sink * parameters.value("LAND_FLARE_SEC") && share > 0.5);
        if (!low && share < 1) {
            return false;
        }
        stage = Stage.FLARED;
        sendText(
                TextSeverity.INFO,
                "Flare %.1fm sink=%.2f speed=%.1f dist=%.1f",
                height,
                sink,
                craft.body().groundSpeed(),
                craft.body().position().horizontalDistanceTo(to));
        return true;
    }

    /** Breaks the landing off: up straight ahead to that height above home. */
    boolean goAround(double metersAboveHome) {
        if (stage != Stage.APPROACH) {
            return false;
        }
        stage = Stage.CLIMBING_AWAY;
        climbTo = metersAboveHome;
        sendText(TextSeverity.WARNING, "Unable to start find a landing abort sequence");
        sendText(TextSeverity.NOTICE, "Landing aborted, climbing to %.0fm", metersAboveHome);
        return true;
    }

    boolean isGoingAround() {
        return stage == Stage.CLIMBING_AWAY;
    }

    /** It was broken off, and is at its height. */
    boolean climbedAway() {
        return climbedAway;
    }

    boolean flared() {
        return stage == Stage.FLARED;
    }

    double metersFromPlace(NeuPosition here) {
        return here.horizontalDistanceTo(to);
    }

    private void sendText(TextSeverity severity, String format, Object... values) {
        events.accept(new FlightEvent.Text(severity, String.format(Locale.ROOT, format, values)));
    }
}
