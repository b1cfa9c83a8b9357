package org.dronemap.sim.autopilot;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dronemap.mavlink.Message;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.Airframe;
import org.dronemap.sim.physics.MulticopterBody;
import org.dronemap.sim.physics.VehicleBody;

/** A kind of simulated autopilot: its name, the banner it sends on connecting, the body it moves, and its factory. */
public record AutopilotKind(String name, String banner, Supplier<VehicleBody> body, Maker maker) {
    /** A quadcopter. */
    public AutopilotKind(String name, String banner, Maker maker) {
        this(name, banner, () -> new MulticopterBody(Airframe.quadcopter(), 0), maker);
    }

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
