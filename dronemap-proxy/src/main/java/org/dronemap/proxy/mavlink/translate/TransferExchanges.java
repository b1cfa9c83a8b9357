package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.LogDownload;
import org.dronemap.proxy.mavlink.procedure.LogListDownload;
import org.dronemap.proxy.mavlink.procedure.ParameterDownload;
import org.dronemap.proxy.mavlink.procedure.ParameterWrite;

/** Makes the exchanges that read and write parameters and download logs, the same for every autopilot. */
final class TransferExchanges {
    private TransferExchanges() {}

    static Exchange download(CommandContext cockpit, Command.DownloadLog command) {
        return new LogDownload(cockpit.target(), command.log(), command.sink(), cockpit.observer());
    }

    static Exchange readLogs(CommandContext cockpit) {
        LogListDownload listing = new LogListDownload(cockpit.target(), cockpit.observer());
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> listing),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    cockpit.news().accept(new DroneEvent.LogsRead(listing.logs()));
                    listing.incomplete().ifPresent(cockpit.warning());
                    return new Outcome.Succeeded();
                }))));
    }

    static Exchange readParameters(CommandContext cockpit) {
        ParameterDownload listing =
                new ParameterDownload(cockpit.target(), cockpit.parameters().codec(), cockpit.observer());
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> listing),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    cockpit.parameters().read(listing.parameters());
                    return listing.incomplete()
                            .<Outcome>map(Outcome.Failed::new)
                            .orElseGet(Outcome.Succeeded::new);
                }))));
    }

    static Exchange set(CommandContext cockpit, Command.SetParameters command) {
        return new ParameterWrite(
                cockpit.target(),
                cockpit.parameters().codec(),
                command.values(),
                cockpit.parameters()::find,
                cockpit.observer());
    }
}
