package org.dronemap.sim.autopilot.arduplane;

import java.util.function.Consumer;
import org.dronemap.sim.flight.Circle;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/**
 * A loiter item of a simulated ArduPlane's mission: circles until its goal is met, and on until it points to the next
 * place.
 */
final class LoiterItem implements Manoeuvre {
    /** Decides whether what it circles for is met. */
    interface Goal {
        boolean isMet(Circle circle, long circlingMillis);
    }

    private static final double LINED_UP_DEGREES = 10;
    private static final double NEXT_IS_INSIDE = 1.05;

    private final Circle circle;
    private final Goal goal;
    private final @Nullable NeuPosition next;
    private final String doneText;
    private final Consumer<FlightEvent> events;
    private long reachedAt = -1;
    private boolean met;
    private boolean done;

    LoiterItem(Circle circle, Goal goal, @Nullable NeuPosition next, String doneText, Consumer<FlightEvent> events) {
        this.circle = circle;
        this.goal = goal;
        this.next = next;
        this.doneText = doneText;
        this.events = events;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        MotionSetpoint setpoint = circle.fly(craft, nowMillis);
        if (circle.reached() && reachedAt < 0) {
            reachedAt = nowMillis;
        }
        met |= reachedAt >= 0 && goal.isMet(circle, nowMillis - reachedAt);
        if (met && !done && isLinedUp(craft)) {
            done = true;
            events.accept(new FlightEvent.Text(TextSeverity.INFO, doneText));
        }
        return setpoint;
    }

    /** With each turn it takes it less exactly, so that no wind can keep it here. */
    private boolean isLinedUp(SimulatedCraft craft) {
        if (next == null || circle.centre().horizontalDistanceTo(next) < NEXT_IS_INSIDE * Math.abs(circle.radius())) {
            return true;
        }
        double wanted = craft.body().position().bearingTo(next);
        double track = Math.atan2(craft.body().velocityEast(), craft.body().velocityNorth());
        double off = Math.abs(Math.toDegrees(Math.IEEEremainder(wanted - track, 2 * Math.PI)));
        return off <= LINED_UP_DEGREES * (1 + Math.floor(circle.turns()));
    }

    @Override
    public boolean done() {
        return done;
    }
}
