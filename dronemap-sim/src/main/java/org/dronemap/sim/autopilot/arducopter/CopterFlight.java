package org.dronemap.sim.autopilot.arducopter;

import java.util.function.Consumer;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotFlight;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMission;
import org.dronemap.sim.autopilot.ardupilot.RallyPoints;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.GoTo;
import org.dronemap.sim.flight.Grounded;
import org.dronemap.sim.flight.Hover;
import org.dronemap.sim.flight.Landing;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.MovingTargetManoeuvre;
import org.dronemap.sim.flight.ReturnHome;
import org.dronemap.sim.flight.ReturnPath;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.SmartReturn;
import org.dronemap.sim.flight.TakeOff;
import org.dronemap.sim.flight.VelocityManoeuvre;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** The current mode of the simulated ArduCopter, and the manoeuvre that it flies in it. */
final class CopterFlight implements ArduPilotFlight {
    private static final int STICK_MID = 1500;
    private static final int STICK_LOW = 1100;
    private static final VelocityManoeuvre.Wanted STANDING = new VelocityManoeuvre.Wanted(true, 0, 0, 0, Double.NaN, 0);

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final ArduPilotMission mission;
    private final ReturnPath returnPath;
    private final RallyPoints rallyPoints;
    private final CruiseSpeeds cruise = new CruiseSpeeds(10, 2.5, 1.5, 0.5);
    private CopterMode mode = CopterMode.STABILIZE;
    private Manoeuvre manoeuvre = new Grounded();
    private @Nullable Manoeuvre paused;
    private boolean autoStarted;
    private int stick = STICK_MID;
    private final ManualControlInput joystick;
    private boolean manualSetpoint;

    CopterFlight(
            SimulatedCraft craft,
            SimulatedMission plan,
            SimulatedParameters parameters,
            ReturnPath returnPath,
            RallyPoints rallyPoints,
            Consumer<FlightEvent> events) {
        this.craft = craft;
        this.parameters = parameters;
        this.returnPath = returnPath;
        this.rallyPoints = rallyPoints;
        this.mission = new ArduPilotMission(plan, event -> report(plan, event, events));
        this.joystick = new ManualControlInput(parameters);
        readSpeeds();
    }

    /** Of a climb to a height it never says that it is done. */
    private static void report(SimulatedMission plan, FlightEvent event, Consumer<FlightEvent> events) {
        boolean silent = event instanceof FlightEvent.ItemReached reached
                && reached.index() < plan.size()
                && plan.item(reached.index()).command() == SimulatedMissionItem.LOITER_TO_ALTITUDE;
        if (!silent) {
            events.accept(event);
        }
    }

    @Override
    public void readSpeeds() {
        cruise.set(
                parameters.value("WPNAV_SPEED") / 100,
                parameters.value("WPNAV_SPEED_UP") / 100,
                parameters.value("WPNAV_SPEED_DN") / 100,
                parameters.value("LAND_SPEED") / 100);
    }

    @Override
    public MotionSetpoint fly(long nowMillis) {
        if (mode == CopterMode.AUTO && craft.landed() && !autoStarted) {
            return new MotionSetpoint.Still();
        }
        if (isFlownManually(nowMillis)) {
            return manualSetpoint(nowMillis);
        }
        if (!isHeldDown()) {
            return manoeuvre.fly(craft, nowMillis);
        }
        if (manoeuvre instanceof TakeOff && craft.body().onGround()) {
            // The motors spool up, but the pilot does not let it climb.
            manoeuvre.fly(craft, nowMillis);
            return new MotionSetpoint.Still();
        }
        return craft.landed() ? manoeuvre.fly(craft, nowMillis) : sink();
    }

    private boolean isFlownManually(long nowMillis) {
        boolean held = mode.followsStick() && !craft.landed() && joystick.isHeld(nowMillis);
        if (manualSetpoint && !held && mode.followsStick()) {
            // It stays where the hands left it.
            manoeuvre = new Hover(craft, cruise);
        }
        manualSetpoint = held;
        return held;
    }

    private MotionSetpoint manualSetpoint(long nowMillis) {
        VelocityManoeuvre.Wanted wanted = joystick.wanted(nowMillis);
        return new VelocityManoeuvre(wanted == null ? STANDING : wanted, cruise).fly(craft, nowMillis);
    }

    private boolean isHeldDown() {
        return mode.followsStick() && stick < STICK_LOW;
    }

    /** The throttle stick at its bottom means "down" in every mode that a pilot flies. */
    private MotionSetpoint sink() {
        double speed = mode == CopterMode.STABILIZE ? 8 : parameters.value("PILOT_SPEED_DN") / 100;
        return new MotionSetpoint.Velocity(
                0, 0, -Math.min(speed, Math.max(0.5, craft.body().up() / 2)), Double.NaN);
    }

    void enter(CopterMode next) {
        if (mode == CopterMode.AUTO) {
            mission.leave();
        }
        if (manoeuvre instanceof SmartReturn back) {
            back.leave();
        }
        mode = next;
        paused = null;
        readSpeeds();
        manoeuvre = switch (next) {
            case AUTO -> startMission();
            case RTL -> returnHome();
            case LAND -> new Landing(craft, cruise);
            case SMART_RTL -> new SmartReturn(craft, returnPath, cruise);
            default -> craft.landed() ? new Grounded() : new Hover(craft, cruise);
        };
        if (next == CopterMode.AUTO && !craft.landed()) {
            autoStarted = true;
        }
    }

    private Manoeuvre startMission() {
        if (!craft.armed() || mission.isEmpty()) {
            return new Grounded();
        }
        return mission.start(cruise, new CopterLegs(parameters, cruise, this::flyHome));
    }

    private Manoeuvre returnHome() {
        return craft.landed() ? new Landing(craft, cruise) : flyHome();
    }

    /** To its home, or to a rally point before it. */
    private ReturnHome flyHome() {
        NeuPosition place = rallyPoints.orHome(craft.homePosition());
        return new ReturnHome(craft, cruise, place, returnHeight(place), (long) parameters.value("RTL_LOIT_TIME"));
    }

    /** Within the cone above the place it does not climb first; a rally point has a height of its own. */
    private double returnHeight(NeuPosition place) {
        double away = craft.body().position().horizontalDistanceTo(place);
        double own = place.up() - craft.homePosition().up();
        double cone = parameters.value("RTL_CONE_SLOPE") > 0 ? away * parameters.value("RTL_CONE_SLOPE") : 1e6;
        return Math.min(Math.max(parameters.value("RTL_ALT") / 100, own), Math.max(2, cone));
    }

    /** MISSION_START: what a pilot does by raising the throttle; a mission that was over goes on from the item set since. */
    void letAutoStart() {
        autoStarted = craft.armed();
        if (mission.flown() == null) {
            manoeuvre = startMission();
        }
    }

    @Override
    public void armed() {
        autoStarted = false;
        if (mode == CopterMode.AUTO) {
            manoeuvre = startMission();
        } else {
            manoeuvre = new Grounded();
        }
    }

    @Override
    public void disarmed() {
        manoeuvre = new Grounded();
        mission.reset();
        paused = null;
        autoStarted = false;
    }

    void takeOff(double metersAboveHome) {
        manoeuvre = new TakeOff(craft, metersAboveHome + craft.homePosition().up(), cruise);
    }

    void goTo(NeuPosition target, double yaw) {
        steerByPosition();
        manoeuvre = new GoTo(target, cruise, yaw);
    }

    /** Follows a place that moves. */
    void pursue(MovingTargetManoeuvre.Moving place, double yaw) {
        steerByPosition();
        manoeuvre = new MovingTargetManoeuvre(place, cruise, yaw);
    }

    /** It begins with the speeds of the parameters: what was asked for during the take-off is lost. */
    private void steerByPosition() {
        if (manoeuvre instanceof TakeOff) {
            readSpeeds();
        }
    }

    void follow(Manoeuvre other) {
        manoeuvre = other;
    }

    boolean pause() {
        if (craft.landed() || (mode != CopterMode.AUTO && mode != CopterMode.GUIDED)) {
            return false;
        }
        if (paused == null) {
            paused = manoeuvre;
            mission.setPaused(true);
            manoeuvre = new Hover(craft, cruise);
        }
        return true;
    }

    boolean resume() {
        if (mode != CopterMode.AUTO && mode != CopterMode.GUIDED) {
            return false;
        }
        if (paused != null) {
            manoeuvre = paused;
            paused = null;
            mission.setPaused(false);
        }
        return true;
    }

    boolean takingOff() {
        boolean climbing = manoeuvre instanceof TakeOff takeOff && !takeOff.done() && !isHeldDown();
        return climbing || (autoStarted && mission.flies(SimulatedMissionItem.TAKEOFF));
    }

    boolean landing() {
        return manoeuvre instanceof Landing
                || (manoeuvre instanceof ReturnHome home && home.landing())
                || (manoeuvre instanceof SmartReturn back && back.landing())
                || mission.landing();
    }

    /** Stands after a landing of its own. */
    boolean hasLanded() {
        boolean landed =
                manoeuvre instanceof Landing || manoeuvre instanceof ReturnHome || manoeuvre instanceof SmartReturn;
        return (landed && manoeuvre.done()) || (mission.ended() && craft.landed());
    }

    CruiseSpeeds cruise() {
        return cruise;
    }

    @Override
    public CopterMode mode() {
        return mode;
    }

    @Override
    public ArduPilotMission mission() {
        return mission;
    }

    /** What a ground station's sticks say. */
    ManualControlInput joystick() {
        return joystick;
    }

    @Override
    public void setStick(int throttle) {
        stick = throttle;
    }
}
