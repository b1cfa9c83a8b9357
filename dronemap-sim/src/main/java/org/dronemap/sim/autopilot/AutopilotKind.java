package org.dronemap.sim.autopilot;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;

/** A kind of simulated autopilot: its name, the banner it sends on connecting, and its factory. */
public record AutopilotKind(String name, String banner, Maker maker) {
    /** Builds an autopilot around a craft. */
    public interface Maker {
        SimulatedAutopilot make(
                SimulatedCraft craft,
                int systemId,
                Consumer<FlightEvent> events,
                Consumer<Message> out,
                Runnable modeAnnouncer);
    }
}
