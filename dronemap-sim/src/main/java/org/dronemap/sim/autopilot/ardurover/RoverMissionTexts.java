package org.dronemap.sim.autopilot.ardurover;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.TextSeverity;

/**
 * Tells what happens in the mission of the simulated ArduRover, in its own sentences. Of several items that are done in
 * one step only the last is told as reached, as the real one does.
 */
final class RoverMissionTexts {
    private static final int NONE = -1;

    private final SimulatedMission plan;
    private final Consumer<FlightEvent> out;
    private final List<String> skipped = new ArrayList<>();
    private int reached = NONE;

    RoverMissionTexts(SimulatedMission plan, Consumer<FlightEvent> out) {
        this.plan = plan;
        this.out = out;
    }

    void handle(FlightEvent event) {
        if (event instanceof FlightEvent.ItemStarted started) {
            sendStart(started, plan.item(started.index()));
        } else if (event instanceof FlightEvent.ItemArrived arrived) {
            sendArrival(arrived.index(), plan.item(arrived.index()));
        } else if (event instanceof FlightEvent.ItemReached done) {
            reached = done.index();
            if (plan.item(reached).command() == SimulatedMissionItem.LOITER_TIME) {
                sendText(TextSeverity.WARNING, "Finished active loiter");
            }
        } else if (event instanceof FlightEvent.MissionEnded) {
            sendText(TextSeverity.NOTICE, "Mission Complete");
        } else {
            out.accept(event);
        }
    }

    /** At the end of each step. */
    void flush() {
        skipped.forEach(text -> sendText(TextSeverity.WARNING, text));
        skipped.clear();
        if (reached != NONE) {
            out.accept(new FlightEvent.ItemReached(reached));
            reached = NONE;
        }
    }

    /** What is done at once never becomes the current item. */
    private void sendStart(FlightEvent.ItemStarted started, SimulatedMissionItem item) {
        if (RoverLegs.isDriven(item)) {
            out.accept(started);
        } else {
            sendText(TextSeverity.INFO, "Mission: " + started.index() + " " + started.type());
        }
        switch (item.command()) {
            case SimulatedMissionItem.CHANGE_SPEED ->
                sendText(TextSeverity.INFO, String.format(Locale.ROOT, "speed: %.1f m/s", item.param2()));
            case SimulatedMissionItem.DELAY -> sendText(TextSeverity.INFO, "Delaying " + (int) item.param1() + " sec");
            case SimulatedMissionItem.CONDITION_YAW -> skipped.add("Skipping invalid cmd #" + item.command());
            default -> {}
        }
    }

    private void sendArrival(int index, SimulatedMissionItem item) {
        boolean toPlace = switch (item.command()) {
            case SimulatedMissionItem.DELAY, SimulatedMissionItem.RETURN_TO_LAUNCH, SimulatedMissionItem.LOITER_TURNS ->
                false;
            default -> true;
        };
        if (toPlace) {
            int seconds = item.command() == SimulatedMissionItem.LOITER_UNLIMITED ? 0 : (int) item.param1();
            sendText(
                    TextSeverity.INFO,
                    "Reached waypoint #" + index + (seconds > 0 ? ". Loiter for " + seconds + " seconds" : ""));
        }
    }

    private void sendText(TextSeverity severity, String text) {
        out.accept(new FlightEvent.Text(severity, text));
    }
}
