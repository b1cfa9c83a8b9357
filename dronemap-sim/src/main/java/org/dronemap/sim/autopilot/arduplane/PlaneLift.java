package org.dronemap.sim.autopilot.arduplane;

import java.util.function.Consumer;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Hover;
import org.dronemap.sim.flight.Landing;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** The lift motors of a simulated QuadPlane: what it flies with them, and when they stop after a landing. */
final class PlaneLift {
    private static final double SPEED = 5;
    private static final double CLIMB = 2.5;
    private static final double SINK = 1.5;
    private static final double STICK_DOWN = 2.5;
    private static final long IDLE_MILLIS = 1_500;
    private static final long LANDED_MILLIS = 6_200;

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final CruiseSpeeds wings;
    private final Consumer<FlightEvent> events;
    private final CruiseSpeeds speeds;
    private final VtolTransition transition;
    private boolean lifting;
    private boolean wasUp;
    private long groundedSince;
    private long now;

    PlaneLift(SimulatedCraft craft, SimulatedParameters parameters, CruiseSpeeds wings, Consumer<FlightEvent> events) {
        this.craft = craft;
        this.parameters = parameters;
        this.wings = wings;
        this.events = events;
        this.speeds = new CruiseSpeeds(SPEED, CLIMB, SINK, parameters.value("Q_LAND_FINAL_SPD"));
        this.transition = new VtolTransition(events);
    }

    /** What it flies in a mode of its lift motors. */
    Manoeuvre forMode(PlaneMode mode, boolean stickLow) {
        return switch (mode) {
            case QLAND -> new Landing(craft, speeds);
            case QRTL -> landAt(craft.homePosition(), parameters.value("Q_RTL_ALT"));
            default -> stickLow && !craft.landed() ? (flown, millis) -> sink() : new Hover(craft, speeds);
        };
    }

    private MotionSetpoint sink() {
        return craft.body().onGround()
                ? new MotionSetpoint.Still()
                : new MotionSetpoint.Velocity(0, 0, -STICK_DOWN, Double.NaN);
    }

    Manoeuvre climbTo(double metersAboveHome) {
        return new LiftClimb(craft.homePosition().up() + metersAboveHome, speeds);
    }

    /** A landing there, which it flies to so many metres above home. */
    Manoeuvre landAt(NeuPosition place, double metersAboveHome) {
        return new LiftLanding(place.withUp(craft.homePosition().up() + metersAboveHome), speeds, wings, events);
    }

    /** Looks at what it is told to fly next; {@code climbs}: from the ground. */
    void check(MotionSetpoint setpoint, PlaneMode mode, boolean climbs, long nowMillis) {
        now = nowMillis;
        boolean up = !craft.body().onGround();
        if (up || !craft.armed()) {
            groundedSince = nowMillis;
        }
        wasUp = craft.armed() && (wasUp || up);
        boolean lifted = craft.armed() && isOfLiftMotors(setpoint);
        boolean idle = nowMillis - groundedSince >= IDLE_MILLIS;
        lifting = lifted && (climbs || (wasUp && !idle));
        transition.check(craft, mode.lifts() || lifted, nowMillis);
    }

    private static boolean isOfLiftMotors(MotionSetpoint setpoint) {
        return setpoint instanceof MotionSetpoint.Reach
                || setpoint instanceof MotionSetpoint.Velocity
                || setpoint instanceof MotionSetpoint.Still;
    }

    /** It takes itself for flying because its lift motors push. */
    boolean lifting() {
        return lifting;
    }

    /** It has stood on the ground long enough after a flight. */
    boolean landed() {
        return wasUp && craft.body().onGround() && now - groundedSince >= LANDED_MILLIS;
    }

    int vtolState() {
        return transition.state();
    }
}
