package org.dronemap.sim.autopilot.ardupilot;

import java.util.function.Consumer;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.MissionLegs;
import org.dronemap.sim.flight.MissionManoeuvre;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.jspecify.annotations.Nullable;

/**
 * The stored mission of a simulated ArduPilot vehicle and how far it is. The number 0 is home, so the first item is 1;
 * another mode than AUTO stops the mission, and AUTO goes on with the same item. Owned by its vehicle.
 */
public final class ArduPilotMission {
    private static final int NONE = 1;
    private static final int NOT_STARTED = 2;
    private static final int ACTIVE = 3;
    private static final int PAUSED = 4;
    private static final int COMPLETE = 5;

    private final SimulatedMission plan;
    private final Consumer<FlightEvent> events;
    private @Nullable MissionManoeuvre flown;
    private int resumeItem;
    private int lastItem;
    private boolean completed;
    private boolean paused;
    private boolean inLanding;

    public ArduPilotMission(SimulatedMission plan, Consumer<FlightEvent> events) {
        this.plan = plan;
        this.events = events;
    }

    /** True when there is nothing beside home. */
    public boolean isEmpty() {
        return plan.size() <= 1;
    }

    /** Goes on with the item that it stopped at, or begins. */
    public MissionManoeuvre start(CruiseSpeeds cruise, MissionLegs legs) {
        completed = false;
        paused = false;
        flown = new MissionManoeuvre(plan, cruise, legs, firstItem(), this::handle);
        return flown;
    }

    private void handle(FlightEvent event) {
        if (event instanceof FlightEvent.MissionEnded) {
            completed = true;
            inLanding = false;
        } else if (event instanceof FlightEvent.ItemStarted started) {
            started(started.index());
        }
        events.accept(event);
    }

    private void started(int index) {
        if (isCommand(index, SimulatedMissionItem.LAND)
                || isCommand(index, SimulatedMissionItem.VTOL_LAND)
                || isCommand(index, SimulatedMissionItem.LAND_START)) {
            inLanding = true;
        } else if (isCommand(index, SimulatedMissionItem.TAKEOFF)
                || isCommand(index, SimulatedMissionItem.VTOL_TAKEOFF)) {
            inLanding = false;
        }
    }

    /** A landing is the last that it began of its mission, and nothing has ended that since. */
    public boolean inLanding() {
        return inLanding;
    }

    /** Another mode is chosen: it remembers the item. */
    public void leave() {
        if (flown != null) {
            lastItem = currentItem();
            resumeItem = flown.ended() ? 0 : flown.index();
            flown = null;
        }
        paused = false;
    }

    /** Begins anew the next time. */
    public void reset() {
        flown = null;
        paused = false;
        inLanding = false;
        resumeItem = 0;
        lastItem = 0;
    }

    public void setPaused(boolean on) {
        paused = on;
    }

    public boolean setCurrentItem(int index) {
        if (index < 0 || index >= plan.size()) {
            return false;
        }
        completed = false;
        inLanding = isCommand(index, SimulatedMissionItem.LAND_START) && inLanding;
        if (flown != null && !flown.ended()) {
            flown.jumpTo(Math.max(1, index));
        } else {
            resumeItem = index;
            flown = null;
        }
        return true;
    }

    /** Other items are stored. */
    public void changed() {
        completed = false;
        if (isEmpty()) {
            flown = null;
        }
        if (flown == null) {
            resumeItem = 0;
        }
    }

    private int firstItem() {
        return Math.max(1, resumeItem);
    }

    /** The item that it stands at, or that the next start begins with, is of that command. */
    public boolean startsWith(int command) {
        return flies(command) || (flown == null && isCommand(firstItem(), command));
    }

    /** The item that is flown is of that command. */
    public boolean flies(int command) {
        return flown != null && !flown.ended() && isCommand(flown.index(), command);
    }

    private boolean isCommand(int index, int command) {
        return index < plan.size() && plan.item(index).command() == command;
    }

    /** The mission that is flown; null when none is. */
    public @Nullable MissionManoeuvre flown() {
        return flown;
    }

    /** True while the present item ends on the ground. */
    public boolean landing() {
        return flown != null && flown.landing();
    }

    public boolean ended() {
        return flown != null && flown.ended();
    }

    /** As MISSION_CURRENT has it. */
    public int currentItem() {
        if (flown == null) {
            return completed ? lastItem : resumeItem;
        }
        return Math.min(flown.index(), Math.max(0, plan.size() - 1));
    }

    /** MISSION_STATE. */
    public int state() {
        if (isEmpty()) {
            return NONE;
        }
        if (completed) {
            return COMPLETE;
        }
        if (flown == null) {
            return NOT_STARTED;
        }
        return paused ? PAUSED : ACTIVE;
    }

    /** A mission that is flown is not cleared. */
    public boolean isActive() {
        return state() == ACTIVE;
    }
}
