package org.dronemap.proxy.session;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Contention;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.mavlink.procedure.Exchange;

/**
 * The commands that are being carried out by one MAVLink vehicle; each is reported ended exactly once. Owned by the
 * drone's lane.
 */
final class ActiveCommands {
    private final Map<CommandId, ActiveCommand> underway = new LinkedHashMap<>();

    private record ActiveCommand(Exchange exchange, VehicleChannel.Report report, boolean transfer) {}

    void begin(CommandId id, Command command, Exchange exchange, VehicleChannel.Report report, long nowNanos) {
        ActiveCommand errand =
                new ActiveCommand(exchange, report, command.kind().contention() == Contention.TRANSFER);
        underway.put(id, errand);
        exchange.start(nowNanos);
        settle();
    }

    void cancel(CommandId id, long nowNanos) {
        ActiveCommand errand = underway.remove(id);
        if (errand != null) {
            errand.exchange().cancel(nowNanos);
        }
    }

    /** Ends all that is under way without knowing what becomes of it; nothing more of it goes out. */
    void abandon(String why) {
        List<ActiveCommand> all = List.copyOf(underway.values());
        underway.clear();
        all.forEach(errand -> errand.report().ended(new Outcome.Unknown(why)));
    }

    boolean isEmpty() {
        return underway.isEmpty();
    }

    /** A command is busy with the mission on the wire. */
    boolean transferring() {
        return underway.values().stream().anyMatch(ActiveCommand::transfer);
    }

    void received(Frame frame, long nowNanos) {
        if (!underway.isEmpty()) {
            underway.values().forEach(errand -> errand.exchange().received(frame, nowNanos));
            settle();
        }
    }

    void textReceived(Severity severity, String text, long nowNanos) {
        underway.values().forEach(errand -> errand.exchange().textReceived(severity, text, nowNanos));
    }

    void advance(long nowNanos) {
        if (!underway.isEmpty()) {
            underway.values().forEach(errand -> errand.exchange().advance(nowNanos));
            settle();
        }
    }

    private void settle() {
        for (Map.Entry<CommandId, ActiveCommand> entry : List.copyOf(underway.entrySet())) {
            Outcome outcome = entry.getValue().exchange().outcome();
            if (outcome != null && underway.remove(entry.getKey(), entry.getValue())) {
                entry.getValue().report().ended(outcome);
            }
        }
    }
}
