package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.flight.WingGuidance;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/**
 * A landing of a simulated QuadPlane at a place: on its wings to near it, and down on its lift motors. It never ends by
 * itself.
 */
final class LiftLanding implements Manoeuvre {
    private static final double AIRBRAKE_METERS = 135;
    private static final long AIRBRAKE_MILLIS = 900;
    private static final double NEAR_METERS = 10;
    private static final double NEAR_SPEED = 8;
    private static final double STEADY_METERS = 2;
    private static final double STEADY_SPEED = 1;
    private static final double FINAL_METERS = 6;
    private static final double BRAKING_SPEED = 20;

    private enum Stage {
        NOT_BEGUN,
        APPROACH,
        AIRBRAKE,
        POSITION1,
        POSITION2,
        DESCEND,
        FINAL
    }

    private final NeuPosition place;
    private final CruiseSpeeds speeds;
    private final WingGuidance approach;
    private final Consumer<FlightEvent> events;
    private Stage stage = Stage.NOT_BEGUN;
    private long begunAt;

    /** {@code place} has the height of the approach; {@code wings} are the speeds of the flight there. */
    LiftLanding(NeuPosition place, CruiseSpeeds speeds, CruiseSpeeds wings, Consumer<FlightEvent> events) {
        this.place = place;
        this.speeds = speeds;
        this.approach = new WingGuidance(wings);
        this.events = events;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        double away = here.horizontalDistanceTo(place);
        // Where it stands at its place already, several stages pass in one moment.
        for (Stage next = next(craft, away, nowMillis); next != stage; next = next(craft, away, nowMillis)) {
            stage = next;
            begunAt = nowMillis;
            report(craft, away);
        }
        return switch (stage) {
            case APPROACH, NOT_BEGUN -> approach.along(craft.body(), here, place, place.up());
            case AIRBRAKE, POSITION1, POSITION2 ->
                new MotionSetpoint.Reach(place.withUp(here.up()), BRAKING_SPEED, 1, 1, Double.NaN);
            case DESCEND, FINAL -> down(craft);
        };
    }

    private Stage next(SimulatedCraft craft, double away, long nowMillis) {
        double speed = craft.body().groundSpeed();
        return switch (stage) {
            case NOT_BEGUN -> away > AIRBRAKE_METERS ? Stage.APPROACH : Stage.AIRBRAKE;
            case APPROACH -> away > AIRBRAKE_METERS ? stage : Stage.AIRBRAKE;
            case AIRBRAKE -> nowMillis - begunAt < AIRBRAKE_MILLIS ? stage : Stage.POSITION1;
            case POSITION1 -> away < NEAR_METERS && speed < NEAR_SPEED ? Stage.POSITION2 : stage;
            case POSITION2 -> away < STEADY_METERS && speed < STEADY_SPEED ? Stage.DESCEND : stage;
            case DESCEND -> craft.aboveHome() < FINAL_METERS ? Stage.FINAL : stage;
            case FINAL -> stage;
        };
    }

    private void report(SimulatedCraft craft, double away) {
        double speed = craft.body().groundSpeed();
        double height = craft.aboveHome();
        switch (stage) {
            case APPROACH -> sendText("VTOL approach d=%.1f", away);
            case AIRBRAKE -> sendText("VTOL airbrake v=%.1f d=%.0f sd=%.0f h=%.1f", speed, away, away, height);
            case POSITION1 -> sendText("VTOL position1 v=%.1f d=%.1f h=%.1f dc=%.1f", speed, away, height, 0.0);
            case POSITION2 -> sendText("VTOL position2 started v=%.1f d=%.1f h=%.1f", speed, away, height);
            case DESCEND -> sendText("Land descend started");
            case FINAL -> sendText("Land final started");
            case NOT_BEGUN -> {}
        }
    }

    private MotionSetpoint down(SimulatedCraft craft) {
        return craft.body().onGround()
                ? new MotionSetpoint.Still()
                : speeds.downAt(place, craft.body().up());
    }

    private void sendText(String format, Object... values) {
        events.accept(new FlightEvent.Text(TextSeverity.INFO, String.format(Locale.ROOT, format, values)));
    }
}
