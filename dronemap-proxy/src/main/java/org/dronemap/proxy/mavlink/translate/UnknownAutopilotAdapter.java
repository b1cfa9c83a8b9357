package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.jspecify.annotations.Nullable;

/** The adapter for vehicles with an unsupported autopilot: they are shown, but not commanded. */
final class UnknownAutopilotAdapter implements AutopilotAdapter {
    private final int number;

    UnknownAutopilotAdapter(int number) {
        this.number = number;
    }

    @Override
    public String family() {
        return number == 0 ? "Generic" : "MAV_AUTOPILOT " + number;
    }

    @Override
    public String vehicle() {
        return family();
    }

    @Override
    public String modeName(Heartbeat heartbeat) {
        return unnamed(heartbeat);
    }

    /** As ground stations show a mode without a name. */
    static String unnamed(Heartbeat heartbeat) {
        return (heartbeat.baseMode() & 1) != 0
                ? "Mode(" + heartbeat.customMode() + ")"
                : String.format(java.util.Locale.ROOT, "Mode(0x%08x)", heartbeat.baseMode());
    }

    @Override
    public List<String> modes() {
        return List.of();
    }

    @Override
    public Capabilities capabilities() {
        return Capabilities.NONE;
    }

    @Override
    public boolean parametersAsBits() {
        return false;
    }

    @Override
    public Optional<String> missionItemLoss(MissionItemInt item) {
        return Optional.of("cannot be put on a vehicle whose autopilot is not known here.");
    }

    @Override
    public int itemsBeforeMission() {
        return 0;
    }

    @Override
    public @Nullable FlightPhase phase(Heartbeat heartbeat) {
        return null;
    }

    @Override
    public Exchange exchangeFor(Command command, CommandContext cockpit) {
        return new ImmediateExchange(() -> new Outcome.Refused(
                "gate",
                new Refusal(
                        OutcomeCode.AUTOPILOT_UNKNOWN,
                        "The ways of this autopilot (" + family() + ") are not known here; nothing was sent.")));
    }

    @Override
    public Optional<Message> steer(Setpoint setpoint, MavlinkTarget target) {
        return Optional.empty();
    }
}
