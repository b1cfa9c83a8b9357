package org.dronemap.sim.autopilot.px4;

import java.util.function.Consumer;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.GoTo;
import org.dronemap.sim.flight.Grounded;
import org.dronemap.sim.flight.Hover;
import org.dronemap.sim.flight.Landing;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.MissionManoeuvre;
import org.dronemap.sim.flight.MulticopterLegs;
import org.dronemap.sim.flight.ReturnHome;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TakeOff;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** The current mode of the simulated PX4 vehicle, and the manoeuvre that it flies in it. */
final class Px4Flight {
    private final SimulatedCraft craft;
    private final SimulatedMission plan;
    private final SimulatedParameters parameters;
    private final Consumer<FlightEvent> events;
    private final CruiseSpeeds cruise = new CruiseSpeeds(5, 3, 1.5, 0.7);
    private final CruiseSpeeds takeOffCruise = new CruiseSpeeds(5, 1.5, 1.5, 0.7);
    private Px4Mode mode = Px4Mode.HOLD;
    private Manoeuvre manoeuvre = new Grounded();
    private @Nullable MissionManoeuvre mission;
    private double takeOffHeight = Double.NaN;
    private int nextItem;
    private boolean completed;
    private boolean flown;
    private boolean holdDue;

    Px4Flight(
            SimulatedCraft craft, SimulatedMission plan, SimulatedParameters parameters, Consumer<FlightEvent> events) {
        this.craft = craft;
        this.plan = plan;
        this.parameters = parameters;
        this.events = events;
        readSpeeds();
    }

    void readSpeeds() {
        double climb = parameters.value("MPC_Z_V_AUTO_UP");
        double sink = parameters.value("MPC_Z_V_AUTO_DN");
        double touchdown = parameters.value("MPC_LAND_SPEED");
        cruise.set(parameters.value("MPC_XY_CRUISE"), climb, sink, touchdown);
        takeOffCruise.set(cruise.horizontal(), parameters.value("MPC_TKO_SPEED"), sink, touchdown);
    }

    MotionSetpoint fly(long nowMillis) {
        flown |= !craft.landed();
        MotionSetpoint setpoint = manoeuvre.fly(craft, nowMillis);
        if (mode == Px4Mode.TAKEOFF && manoeuvre instanceof TakeOff && manoeuvre.done()) {
            holdDue = true;
        }
        return setpoint;
    }

    /** After a take-off or a mission that ends in the air it holds. */
    void holdNext() {
        holdDue = true;
    }

    boolean pollHold() {
        boolean due = holdDue;
        holdDue = false;
        return due;
    }

    void enter(Px4Mode next) {
        if (mission != null) {
            nextItem = mission.ended() ? 0 : mission.index();
            mission = null;
        }
        mode = next;
        readSpeeds();
        manoeuvre = craft.armed() ? manoeuvreFor(next) : new Grounded();
    }

    private Manoeuvre manoeuvreFor(Px4Mode next) {
        return switch (next) {
            case TAKEOFF -> takeOffNow();
            case MISSION -> startMission();
            case RETURN -> returnHome();
            case LAND -> new Landing(craft, cruise);
            default -> craft.landed() ? new Grounded() : new Hover(craft, cruise);
        };
    }

    private Manoeuvre takeOffNow() {
        double height = Double.isNaN(takeOffHeight) ? parameters.value("MIS_TAKEOFF_ALT") : takeOffHeight;
        return new TakeOff(craft, height + craft.homePosition().up(), takeOffCruise);
    }

    private Manoeuvre startMission() {
        completed = false;
        int first = nextItem < plan.size() ? nextItem : 0;
        mission = new MissionManoeuvre(
                plan, cruise, new MulticopterLegs(cruise, parameters.value("RTL_RETURN_ALT")), first, this::handle);
        return mission;
    }

    private void handle(FlightEvent event) {
        completed |= event instanceof FlightEvent.MissionEnded;
        events.accept(event);
    }

    private Manoeuvre returnHome() {
        long wait = (long) (Math.max(0, parameters.value("RTL_LAND_DELAY")) * 1000);
        return craft.landed()
                ? new Landing(craft, cruise)
                : new ReturnHome(craft, cruise, parameters.value("RTL_RETURN_ALT"), wait);
    }

    void armed() {
        flown = false;
        manoeuvre = manoeuvreFor(mode);
    }

    void disarmed() {
        manoeuvre = new Grounded();
        mission = null;
        nextItem = 0;
        takeOffHeight = Double.NaN;
        if (mode == Px4Mode.TAKEOFF) {
            mode = Px4Mode.HOLD;
        }
    }

    /** Metres above home for the next take-off, NaN for the parameter's. */
    void setTakeOffHeight(double metersAboveHome) {
        takeOffHeight = metersAboveHome;
    }

    void goTo(NeuPosition target, double yaw) {
        manoeuvre = new GoTo(target, cruise, yaw);
    }

    boolean setCurrentItem(int index) {
        if (index < 0 || index >= plan.size()) {
            return false;
        }
        completed = false;
        if (mission != null && !mission.ended()) {
            mission.jumpTo(index);
        } else {
            nextItem = index;
        }
        return true;
    }

    void missionChanged() {
        completed = false;
        nextItem = 0;
        if (mission != null && plan.size() > 0) {
            mission.jumpTo(0);
        }
    }

    boolean takingOff() {
        boolean climbing = manoeuvre instanceof TakeOff takeOff && !takeOff.done();
        return climbing || (mission != null && !mission.ended() && craft.landed() && !flown);
    }

    boolean landing() {
        return manoeuvre instanceof Landing
                || (manoeuvre instanceof ReturnHome home && home.landing())
                || (mission != null && mission.landing());
    }

    boolean hasFlown() {
        return flown;
    }

    int currentItem() {
        return mission == null ? nextItem : Math.min(mission.index(), Math.max(0, plan.size() - 1));
    }

    int missionState() {
        if (plan.size() == 0) {
            return 1;
        }
        if (completed) {
            return 5;
        }
        return mission == null ? (nextItem > 0 ? 4 : 2) : 3;
    }

    CruiseSpeeds cruise() {
        return cruise;
    }

    Px4Mode mode() {
        return mode;
    }
}
