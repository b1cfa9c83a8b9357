package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.jspecify.annotations.Nullable;

/**
 * Adapts the server to one autopilot family: flight modes, capabilities, and commands as MAVLink exchanges. Stateless;
 * any thread.
 */
public interface AutopilotAdapter {
    /** The family of a MAV_AUTOPILOT number. */
    static AutopilotAdapter of(Heartbeat heartbeat) {
        return switch (heartbeat.autopilot()) {
            case 3 -> new ArduPilotAdapter(heartbeat.type());
            case 12 -> new Px4Adapter(heartbeat.type());
            default -> new UnknownAutopilotAdapter(heartbeat.autopilot());
        };
    }

    /** The name users know, such as ArduPilot. */
    String family();

    /** The firmware flavour users know, such as ArduCopter. */
    String vehicle();

    /** The name of the mode that a heartbeat tells. */
    String modeName(Heartbeat heartbeat);

    /** What it tells beside that which all do, and microseconds between two. */
    default Map<Integer, Long> ownMessages() {
        return Map.of();
    }

    /** Names that can be set. */
    List<String> modes();

    Capabilities capabilities();

    /** How many items of a mission on the wire stand before the first real one (home). */
    int itemsBeforeMission();

    /** What of a client's mission item this vehicle would not get as it stands, in words after the item's number. */
    Optional<String> missionItemLoss(MissionItemInt item);

    /** Parameters that are whole numbers travel as their bits, not as their value. */
    boolean parametersAsBits();

    /** Ground or air as the heartbeat's system status tells; null where it does not. */
    @Nullable
    FlightPhase phase(Heartbeat heartbeat);

    /** How a command is carried out on this autopilot. */
    Exchange exchangeFor(Command command, CommandContext cockpit);

    /** What says a setpoint to this autopilot; empty when nothing does. */
    Optional<Message> steer(Setpoint setpoint, MavlinkTarget target);
}
