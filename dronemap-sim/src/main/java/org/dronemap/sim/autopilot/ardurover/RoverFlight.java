package org.dronemap.sim.autopilot.ardurover;

import java.util.function.Consumer;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotFlight;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMission;
import org.dronemap.sim.autopilot.ardupilot.RallyPoints;
import org.dronemap.sim.flight.Braking;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.DriveTo;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Grounded;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.ReturnPath;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.StayNear;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/**
 * The current mode of the simulated ArduRover, and how it drives in it. Nobody is at its sticks: driven by hand it rolls
 * out and stands.
 */
final class RoverFlight implements ArduPilotFlight {
    private static final MotionSetpoint STILL = new MotionSetpoint.Still();
    private static final double BOAT = 2;
    private static final int GUIDED_PLACE = 0;
    private static final int DONE_LOITER = 1;
    private static final int DONE_ACRO = 2;
    private static final int DONE_MANUAL = 3;

    private final SimulatedCraft craft;
    private final SimulatedMission plan;
    private final SimulatedParameters parameters;
    private final Consumer<FlightEvent> events;
    private final ReturnPath returnPath;
    private final RallyPoints rallyPoints;
    private final RoverMissionTexts texts;
    private final ArduPilotMission mission;
    private final CruiseSpeeds cruise = new CruiseSpeeds(5, 0, 0, 0);
    private RoverMode mode = RoverMode.MANUAL;
    private Manoeuvre manoeuvre = new Grounded();
    private boolean arrivalDue;
    private boolean missionDone;

    RoverFlight(
            SimulatedCraft craft,
            SimulatedMission plan,
            SimulatedParameters parameters,
            ReturnPath returnPath,
            RallyPoints rallyPoints,
            Consumer<FlightEvent> events) {
        this.craft = craft;
        this.plan = plan;
        this.parameters = parameters;
        this.returnPath = returnPath;
        this.rallyPoints = rallyPoints;
        this.events = events;
        this.texts = new RoverMissionTexts(plan, events);
        this.mission = new ArduPilotMission(plan, this::handle);
        readSpeeds();
    }

    private void handle(FlightEvent event) {
        texts.handle(event);
        missionDone |= event instanceof FlightEvent.MissionEnded;
    }

    /** The mode that the end of the mission asks for by MIS_DONE_BEHAVE; null when it stays in AUTO. Told once. */
    @Nullable
    RoverMode pollModeAtEnd() {
        if (!missionDone) {
            return null;
        }
        missionDone = false;
        int behaviour = (int) parameters.value("MIS_DONE_BEHAVE");
        if (behaviour == DONE_LOITER) {
            manoeuvre = loiter();
        }
        return switch (behaviour) {
            case DONE_ACRO -> RoverMode.ACRO;
            case DONE_MANUAL -> RoverMode.MANUAL;
            default -> null;
        };
    }

    @Override
    public void readSpeeds() {
        double set = parameters.value("WP_SPEED");
        cruise.setHorizontal(set > 0 ? set : parameters.value("CRUISE_SPEED"));
    }

    @Override
    public MotionSetpoint fly(long nowMillis) {
        if (!craft.armed()) {
            return STILL;
        }
        MotionSetpoint setpoint = manoeuvre.fly(craft, nowMillis);
        if (arrivalDue && manoeuvre.done()) {
            arrivalDue = false;
            reportArrival();
        }
        texts.flush();
        return setpoint;
    }

    private void reportArrival() {
        if (mode == RoverMode.GUIDED) {
            events.accept(new FlightEvent.ItemReached(GUIDED_PLACE));
        } else {
            events.accept(new FlightEvent.Text(TextSeverity.INFO, "Reached destination"));
        }
        if (isBoat()) {
            manoeuvre = loiter();
        }
    }

    void enter(RoverMode next) {
        if (mode == RoverMode.AUTO) {
            mission.leave();
        }
        if (manoeuvre instanceof RoverSmartReturn back) {
            back.leave();
        }
        mode = next;
        arrivalDue = next == RoverMode.RTL || next == RoverMode.SMART_RTL;
        readSpeeds();
        manoeuvre = switch (next) {
            case AUTO -> startMission();
            case RTL -> returnHome();
            case SMART_RTL -> new RoverSmartReturn(returnPath, cruise, parameters.value("WP_RADIUS"));
            case LOITER -> loiter();
            case GUIDED -> isBoat() ? loiter() : new Braking();
            default -> new Grounded();
        };
    }

    private Manoeuvre startMission() {
        if (mission.isEmpty()) {
            return new Braking();
        }
        return mission.start(cruise, new RoverLegs(plan, cruise, parameters.value("WP_RADIUS")));
    }

    private Manoeuvre returnHome() {
        if (parameters.value("RTL_SPEED") > 0) {
            cruise.setHorizontal(parameters.value("RTL_SPEED"));
        }
        return new DriveTo(craft, rallyPoints.orHome(craft.homePosition()), cruise, parameters.value("WP_RADIUS"));
    }

    private Manoeuvre loiter() {
        return new StayNear(craft, cruise, parameters.value("LOIT_RADIUS"));
    }

    boolean isBoat() {
        return parameters.value("FRAME_CLASS") == BOAT;
    }

    @Override
    public void armed() {
        if (mode == RoverMode.AUTO && mission.flown() == null) {
            manoeuvre = startMission();
        }
    }

    /** In AUTO the mission stays where it is. */
    @Override
    public void disarmed() {
        if (mode != RoverMode.AUTO) {
            mission.reset();
        }
    }

    /** Drives to a place as GUIDED does. */
    void goTo(NeuPosition place) {
        manoeuvre = new DriveTo(craft, place, cruise, parameters.value("WP_RADIUS"));
        arrivalDue = true;
    }

    void follow(Manoeuvre other) {
        manoeuvre = other;
        arrivalDue = false;
    }

    /** False while it has no way to drive that a speed could be for. */
    boolean changeSpeed(double metersPerSecond) {
        boolean onTheWay = switch (mode) {
            case AUTO, RTL, SMART_RTL -> true;
            case GUIDED -> manoeuvre instanceof DriveTo;
            default -> false;
        };
        if (!onTheWay || !(metersPerSecond > 0)) {
            return false;
        }
        cruise.setHorizontal(metersPerSecond);
        return true;
    }

    CruiseSpeeds cruise() {
        return cruise;
    }

    @Override
    public RoverMode mode() {
        return mode;
    }

    @Override
    public void setStick(int throttle) {
        // Nobody is at its sticks.
    }

    @Override
    public ArduPilotMission mission() {
        return mission;
    }
}
