package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.mavlink.procedure.Conclusion;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.LogDownload;
import org.dronemap.proxy.mavlink.procedure.LogListing;
import org.dronemap.proxy.mavlink.procedure.ParameterListing;
import org.dronemap.proxy.mavlink.procedure.ParameterWriting;
import org.dronemap.proxy.mavlink.procedure.Sequence;

/** Makes the exchanges for parameters and logs, which are the same for every autopilot. */
final class CommonPlans {
    private CommonPlans() {}

    static Exchange download(Cockpit cockpit, Command.DownloadLog command) {
        return new LogDownload(cockpit.target(), command.log(), command.sink(), cockpit.observer());
    }

    static Exchange readLogs(Cockpit cockpit) {
        LogListing listing = new LogListing(cockpit.target(), cockpit.observer());
        return new Sequence(List.of(
                Sequence.Step.of(() -> listing),
                Sequence.Step.of(() -> new Conclusion(() -> {
                    cockpit.news().accept(new DroneEvent.LogsRead(listing.logs()));
                    return new Outcome.Succeeded();
                }))));
    }

    static Exchange readParameters(Cockpit cockpit) {
        ParameterListing listing =
                new ParameterListing(cockpit.target(), cockpit.parameters().codec(), cockpit.observer());
        return new Sequence(List.of(
                Sequence.Step.of(() -> listing),
                Sequence.Step.of(() -> new Conclusion(() -> {
                    cockpit.parameters().read(listing.parameters());
                    return new Outcome.Succeeded();
                }))));
    }

    static Exchange set(Cockpit cockpit, Command.SetParameters command) {
        return new ParameterWriting(
                cockpit.target(),
                cockpit.parameters().codec(),
                command.values(),
                cockpit.parameters()::find,
                cockpit.observer());
    }
}
