package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.proxy.mavlink.procedure.Conclusion;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.LogDownload;
import org.dronemap.proxy.mavlink.procedure.LogListing;
import org.dronemap.proxy.mavlink.procedure.ParameterListing;
import org.dronemap.proxy.mavlink.procedure.ParameterWriting;
import org.dronemap.proxy.mavlink.procedure.Sequence;
import org.jspecify.annotations.Nullable;

/** What every autopilot does in the same way: pictures, home, parameters, logs, fences and rally points. */
final class CommonPlans {
    private CommonPlans() {}

    /** Null for a command that autopilots do each in its own way. */
    static @Nullable Exchange plan(Command command, Cockpit cockpit) {
        if (command instanceof Command.TakePicture) {
            return Maneuvers.picture(cockpit);
        }
        if (command instanceof Command.ReadParameters) {
            return read(cockpit);
        }
        if (command instanceof Command.SetParameters set) {
            return set(cockpit, set.values());
        }
        if (command instanceof Command.SetHome home) {
            return HomePlans.set(cockpit, home);
        }
        if (command instanceof Command.ReadHome) {
            return HomePlans.read(cockpit);
        }
        if (command instanceof Command.ReadLogs) {
            return logs(cockpit);
        }
        return command instanceof Command.DownloadLog download
                ? new LogDownload(cockpit.target(), download.log(), download.sink(), cockpit.observer())
                : FencePlans.plan(command, cockpit);
    }

    private static Exchange logs(Cockpit cockpit) {
        LogListing listing = new LogListing(cockpit.target(), cockpit.observer());
        return new Sequence(List.of(
                Sequence.Step.of(() -> listing),
                Sequence.Step.of(() -> new Conclusion(() -> {
                    cockpit.news().accept(new DroneEvent.LogsRead(listing.logs()));
                    return new Outcome.Succeeded();
                }))));
    }

    private static Exchange read(Cockpit cockpit) {
        ParameterListing listing =
                new ParameterListing(cockpit.target(), cockpit.parameters().codec(), cockpit.observer());
        return new Sequence(List.of(
                Sequence.Step.of(() -> listing),
                Sequence.Step.of(() -> new Conclusion(() -> {
                    cockpit.parameters().read(listing.parameters());
                    return new Outcome.Succeeded();
                }))));
    }

    private static Exchange set(Cockpit cockpit, List<ParameterValue> values) {
        return new ParameterWriting(
                cockpit.target(), cockpit.parameters().codec(), values, cockpit.parameters()::find, cockpit.observer());
    }
}
