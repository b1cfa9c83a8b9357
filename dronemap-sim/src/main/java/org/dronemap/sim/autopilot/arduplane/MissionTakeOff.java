package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.MotionSetpoint;

/** The take-off item of a simulated ArduPlane's mission: straight ahead to its height, wherever its place is. */
final class MissionTakeOff implements Manoeuvre {
    private static final double COURSE_SPEED = 5;
    private static final long COURSE_MILLIS = 2_000;
    private static final double LEVEL_OFF_SECONDS = 2.4;

    private final double metersAboveHome;
    private final PlaneLaunch launch;
    private final Consumer<FlightEvent> events;
    private long quickSince = -1;
    private boolean courseHeld;
    private boolean levelling;
    private boolean done;

    MissionTakeOff(double metersAboveHome, boolean flying, Consumer<FlightEvent> events) {
        this.metersAboveHome = metersAboveHome;
        this.launch = new PlaneLaunch(events);
        this.events = events;
        if (flying) {
            launch.release();
        }
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (!launch.released(craft, nowMillis)) {
            return new MotionSetpoint.Glide();
        }
        if (!done && craft.aboveHome() > metersAboveHome) {
            done = true;
            sendText("Takeoff complete at %.2fm", craft.aboveHome());
        }
        if (!done) {
            report(craft, nowMillis);
        }
        return ClimbOut.setpoint();
    }

    private void report(SimulatedCraft craft, long nowMillis) {
        double speed = craft.body().groundSpeed();
        if (quickSince < 0 && speed > COURSE_SPEED) {
            quickSince = nowMillis;
        }
        if (!courseHeld && quickSince >= 0 && nowMillis - quickSince >= COURSE_MILLIS) {
            courseHeld = true;
            sendText("Holding course %.0f at %.1fm/s (0.0)", degrees(craft) * 100, speed);
        }
        double soon = craft.aboveHome() + craft.body().velocityUp() * LEVEL_OFF_SECONDS;
        if (!levelling && craft.body().up() > 1 && soon >= metersAboveHome) {
            levelling = true;
            sendText("Takeoff level-off starting at %.0fm", craft.aboveHome());
        }
    }

    private static double degrees(SimulatedCraft craft) {
        return (Math.toDegrees(craft.body().yaw()) + 360) % 360;
    }

    private void sendText(String format, Object... values) {
        events.accept(new FlightEvent.Text(TextSeverity.INFO, String.format(Locale.ROOT, format, values)));
    }

    @Override
    public boolean done() {
        return done;
    }
}
