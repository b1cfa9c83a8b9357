package org.dronemap.sim.autopilot.arduplane;

import java.util.function.Consumer;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMission;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.TextSeverity;

/** The landing of a simulated ArduPlane's mission: where it begins, and how it is begun from there or anew. */
final class LandingSequence {
    private static final int NONE = -1;

    private final SimulatedCraft craft;
    private final SimulatedMission plan;
    private final ArduPilotMission mission;
    private final Consumer<FlightEvent> events;

    LandingSequence(
            SimulatedCraft craft, SimulatedMission plan, ArduPilotMission mission, Consumer<FlightEvent> events) {
        this.craft = craft;
        this.plan = plan;
        this.mission = mission;
        this.events = events;
    }

    boolean exists() {
        return first() != NONE;
    }

    /** The number of the DO_LAND_START whose approach is nearest; -1 when the mission has none. */
    private int first() {
        int best = NONE;
        double nearest = Double.POSITIVE_INFINITY;
        for (int index = 1; index < plan.size(); index++) {
            SimulatedMissionItem item = plan.item(index);
            if (item.command() == SimulatedMissionItem.LAND_START) {
                double away = item.hasPlace() ? craft.body().position().distanceTo(craft.targetOf(item)) : 0;
                if (away < nearest) {
                    nearest = away;
                    best = index;
                }
            }
        }
        return best;
    }

    /** The mission goes on from its DO_LAND_START; {@code flown}: it is flown already. */
    boolean start(boolean flown) {
        int first = first();
        if (first == NONE) {
            sendText(TextSeverity.WARNING, "Unable to start landing sequence");
            return false;
        }
        mission.setCurrentItem(first);
        if (!flown) {
            sendTextsFrom(first);
        }
        sendText(TextSeverity.INFO, "Landing sequence start");
        return true;
    }

    /** Says the items from that one to the first that is flown, as when a mission that rests is set to them. */
    private void sendTextsFrom(int index) {
        for (int item = index; item < plan.size(); item++) {
            sendText(
                    TextSeverity.INFO,
                    "Mission: " + item + " " + plan.item(item).typeName());
            if (plan.item(item).isNavigation()) {
                return;
            }
        }
    }

    /** A landing that was broken off or left at that item is begun again from its approach. */
    void beginAnew(int index) {
        int first = first();
        if (first != NONE) {
            sendText(TextSeverity.NOTICE, "Restarted landing via DO_LAND_START: " + first);
            mission.setCurrentItem(first);
            return;
        }
        for (int before = index - 1; before > 0; before--) {
            SimulatedMissionItem item = plan.item(before);
            if (item.isNavigation() && item.hasPlace()) {
                sendText(TextSeverity.NOTICE, "Restarted landing sequence at waypoint " + before);
                mission.setCurrentItem(before);
                return;
            }
        }
        sendText(TextSeverity.WARNING, "Unable to restart landing sequence");
    }

    private void sendText(TextSeverity severity, String text) {
        events.accept(new FlightEvent.Text(severity, text));
    }
}
