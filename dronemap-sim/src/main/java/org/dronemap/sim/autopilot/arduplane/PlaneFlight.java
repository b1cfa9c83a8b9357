package org.dronemap.sim.autopilot.arduplane;

import java.util.function.Consumer;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotFlight;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMission;
import org.dronemap.sim.autopilot.ardupilot.RallyPoints;
import org.dronemap.sim.flight.Circle;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** The current mode of the simulated ArduPlane, and the manoeuvre that it flies in it. */
final class PlaneFlight implements ArduPilotFlight {
    private static final int STICK_LOW = 1100;
    private static final int STICK_MID = 1500;
    private static final int NONE = -1;
    private static final int QRTL_AT_HOME = 1;
    private static final int LAND_AFTER_RETURN = 1;
    private static final int LAND_AT_ONCE = 2;
    private static final double NEAR_HEIGHT_METERS = 10;

    private final SimulatedCraft craft;
    private final SimulatedMission plan;
    private final SimulatedParameters parameters;
    private final Consumer<FlightEvent> events;
    private final Consumer<PlaneMode> changer;
    private final ArduPilotMission mission;
    private final LandingSequence landingSequence;
    private final RallyPoints rallyPoints;
    private final FlyingEstimate estimate = new FlyingEstimate();
    private final CruiseSpeeds cruise = new CruiseSpeeds(0, 0, 0, 0);
    private PlaneMode mode;
    private Manoeuvre manoeuvre;
    private final @Nullable PlaneLift lift;
    private @Nullable PlaneLegs legs;
    private @Nullable Circle guided;
    private int reachedItem = NONE;
    private @Nullable PlaneMode next;
    private int stick = STICK_MID;
    private boolean inLandingSequence;

    /** {@code changer} changes the mode when the flight itself asks for another one; {@code lifts}: it has lift motors. */
    PlaneFlight(
            SimulatedCraft craft,
            SimulatedMission plan,
            SimulatedParameters parameters,
            RallyPoints rallyPoints,
            Consumer<FlightEvent> events,
            Consumer<PlaneMode> changer,
            boolean lifts) {
        this.craft = craft;
        this.plan = plan;
        this.parameters = parameters;
        this.events = events;
        this.changer = changer;
        this.rallyPoints = rallyPoints;
        this.mission = new ArduPilotMission(plan, this::handle);
        this.landingSequence = new LandingSequence(craft, plan, mission, events);
        this.lift = lifts ? new PlaneLift(craft, parameters, cruise, events) : null;
        // As the switch of the remote control stood with each of the two that were recorded.
        this.mode = lifts ? PlaneMode.FLY_BY_WIRE_A : PlaneMode.MANUAL;
        this.manoeuvre = byPilot(mode);
        readSpeeds();
    }

    @Override
    public void readSpeeds() {
        cruise.set(
                parameters.value("AIRSPEED_CRUISE"),
                parameters.value("TECS_CLMB_MAX"),
                parameters.value("TECS_SINK_MAX"),
                1);
    }

    @Override
    public MotionSetpoint fly(long nowMillis) {
        estimate.check(craft, lift != null && lift.lifting(), nowMillis);
        restartLanding();
        MotionSetpoint setpoint = manoeuvre.fly(craft, nowMillis);
        if (mode == PlaneMode.RTL && craft.armed() && manoeuvre instanceof Circle circle) {
            landAfterReturn(circle);
        }
        if (mode == PlaneMode.AUTO && mission.flown() == null) {
            next = PlaneMode.RTL;
        }
        reportPlace();
        reportReached();
        if (next != null) {
            PlaneMode wanted = next;
            next = null;
            changer.accept(wanted);
        }
        MotionSetpoint chosen = craft.body().onGround() && !mayPower() ? new MotionSetpoint.Glide() : setpoint;
        if (lift != null) {
            lift.check(chosen, mode, climbsOnLift(), nowMillis);
        }
        return chosen;
    }

    private boolean climbsOnLift() {
        return manoeuvre instanceof LiftClimb || mission.flies(SimulatedMissionItem.VTOL_TAKEOFF);
    }

    /** On the ground only a take-off, and a landing that is broken off, has power. */
    private boolean mayPower() {
        PlaneLanding landing = landing();
        return mode.lifts()
                || climbsOnLift()
                || manoeuvre instanceof TakeOffMode
                || mission.flies(SimulatedMissionItem.TAKEOFF)
                || (landing != null && landing.isGoingAround());
    }

    private void handle(FlightEvent event) {
        if (event instanceof FlightEvent.ItemReached reached) {
            // Of several in one moment the last alone is told, as of a real one.
            reachedItem = reached.index();
        } else if (event instanceof FlightEvent.ItemStarted started) {
            start(started);
        } else if (event instanceof FlightEvent.MissionEnded) {
            sendText(TextSeverity.INFO, "Mission complete, changing mode to RTL");
            next = PlaneMode.RTL;
        } else {
            events.accept(event);
        }
    }

    /** An item that only sets something is said, but is never the current one. */
    private void start(FlightEvent.ItemStarted started) {
        int index = started.index();
        if (index < plan.size() && plan.item(index).isNavigation()) {
            inLandingSequence = plan.item(index).command() == SimulatedMissionItem.LAND;
        }
        if (index < plan.size() && !plan.item(index).isNavigation()) {
            sendText(TextSeverity.INFO, "Mission: " + index + " " + started.type());
        } else {
            events.accept(started);
        }
    }

    private void reportReached() {
        if (reachedItem != NONE) {
            events.accept(new FlightEvent.ItemReached(reachedItem));
            reachedItem = NONE;
        }
    }

    /** In GUIDED the place is said to be reached, as if it were an item of that number. */
    private void reportPlace() {
        Circle circle = guided;
        if (circle != null && circle.reached()) {
            guided = null;
            reachedItem = 0;
        }
    }

    void enter(PlaneMode chosen) {
        if (mode == PlaneMode.AUTO) {
            leaveMission();
        }
        mode = chosen;
        forgetLanding();
        guided = null;
        if (mission.inLanding() && !craft.armed() && !flies() && !chosen.needsPosition()) {
            sendText(TextSeverity.INFO, "In landing sequence: mission reset");
            mission.reset();
        }
        readSpeeds();
        manoeuvre = switch (chosen) {
            case AUTO -> startMission();
            case TAKEOFF -> new TakeOffMode(parameters, cruise, estimate, events);
            case RTL -> new Circle(returnPlace(), returnRadius(), cruise);
            case GUIDED -> guide(craft.body().position(), 0);
            case LOITER, CIRCLE -> circle(craft.body().position(), 0);
            default -> lift != null && chosen.lifts() ? lift.forMode(chosen, stick < STICK_LOW) : byPilot(chosen);
        };
    }

    private PilotFlight byPilot(PlaneMode chosen) {
        return new PilotFlight(
                chosen.pilotHoldsHeight(), () -> stick < STICK_LOW, parameters.value("AIRSPEED_MIN"), cruise);
    }

    /** What its owner has set for its end at home; without that it circles there. */
    private void landAfterReturn(Circle circle) {
        if (lift != null && parameters.value("Q_RTL_MODE") == QRTL_AT_HOME && circle.reached()) {
            next = PlaneMode.QRTL;
            return;
        }
        int autoland = (int) parameters.value("RTL_AUTOLAND");
        boolean home =
                circle.reached() && Math.abs(circle.centre().up() - craft.body().up()) < NEAR_HEIGHT_METERS;
        if (autoland == LAND_AT_ONCE || (autoland == LAND_AFTER_RETURN && home)) {
            next = landingSequence.exists() && landingSequence.start(false) ? PlaneMode.AUTO : null;
        }
    }

    private Manoeuvre startMission() {
        PlaneLegs begun = new PlaneLegs(
                plan,
                parameters,
                cruise,
                estimate,
                lift,
                new PlaneLegs.MissionLink(mission::currentItem, () -> next = PlaneMode.RTL, events));
        legs = begun;
        return mission.start(cruise, begun);
    }

    /** A landing that is left is begun from its approach the next time. */
    private void leaveMission() {
        if (mission.flown() == null) {
            sendText(TextSeverity.INFO, "Aircraft in auto without a running mission");
        }
        boolean landing = mission.flies(SimulatedMissionItem.LAND) && landing() != null;
        int index = mission.currentItem();
        mission.leave();
        legs = null;
        if (landing) {
            landingSequence.beginAnew(index);
        }
    }

    /** On the ground after a landing: a mode that does not steer by itself ends the mission. */
    private void forgetLanding() {
        if (inLandingSequence && !craft.armed() && !flies() && !mode.needsPosition()) {
            sendText(TextSeverity.INFO, "In landing sequence: mission reset");
            mission.reset();
            inLandingSequence = false;
        }
    }

    private void restartLanding() {
        PlaneLanding landing = landing();
        if (landing != null && landing.climbedAway()) {
            landingSequence.beginAnew(mission.currentItem());
        }
    }

    private NeuPosition returnPlace() {
        NeuPosition home = craft.homePosition();
        return rallyPoints.orHome(home.withUp(home.up() + parameters.value("RTL_ALTITUDE")));
    }

    private double returnRadius() {
        double radius = parameters.value("RTL_RADIUS");
        return radius == 0 ? parameters.value("WP_LOITER_RAD") : radius;
    }

    private Circle circle(NeuPosition place, double radius) {
        return new Circle(place, radius == 0 ? parameters.value("WP_LOITER_RAD") : radius, cruise);
    }

    private Circle guide(NeuPosition place, double radius) {
        Circle circle = circle(place, radius);
        guided = circle;
        return circle;
    }

    /** GUIDED: circles around that place from now on; a radius of 0 is that of the parameters. */
    void goTo(NeuPosition place, double radius) {
        manoeuvre = guide(place, radius);
    }

    /** GUIDED: up on its lift motors; only of a vehicle that has some. */
    void climbTo(double metersAboveHome) {
        if (lift == null) {
            throw new IllegalStateException("an aeroplane without lift motors cannot climb on them");
        }
        guided = null;
        manoeuvre = lift.climbTo(metersAboveHome);
    }

    /** GUIDED: the height alone is another one. */
    void changeHeight(double up) {
        if (manoeuvre instanceof Circle circle) {
            boolean told = guided == null;
            Circle higher = circle(circle.centre().withUp(up), circle.radius());
            manoeuvre = higher;
            guided = told ? null : higher;
        }
    }

    LandingSequence landingSequence() {
        return landingSequence;
    }

    /** The landing that is flown; null when none is. */
    @Nullable
    PlaneLanding landing() {
        return legs == null ? null : legs.landing();
    }

    @Override
    public void armed() {}

    @Override
    public void disarmed() {
        readSpeeds();
        if (mode != PlaneMode.AUTO) {
            mission.reset();
        }
    }

    /** Its mission landed it, and what comes next of that is no take-off. */
    boolean staysInLanding() {
        return mission.inLanding()
                && !craft.armed()
                && !mission.startsWith(SimulatedMissionItem.TAKEOFF)
                && !mission.startsWith(SimulatedMissionItem.VTOL_TAKEOFF);
    }

    /** Its lift motors; null when it has none. */
    @Nullable
    PlaneLift lift() {
        return lift;
    }

    boolean flies() {
        return estimate.isFlying(craft.armed());
    }

    FlyingEstimate estimate() {
        return estimate;
    }

    CruiseSpeeds cruise() {
        return cruise;
    }

    @Override
    public PlaneMode mode() {
        return mode;
    }

    @Override
    public ArduPilotMission mission() {
        return mission;
    }

    @Override
    public void setStick(int throttle) {
        stick = throttle;
    }

    private void sendText(TextSeverity severity, String text) {
        events.accept(new FlightEvent.Text(severity, text));
    }
}
