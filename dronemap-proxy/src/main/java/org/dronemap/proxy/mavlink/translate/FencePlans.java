package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.function.Consumer;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.Counted;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Conclusion;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.MissionClear;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.dronemap.proxy.mavlink.procedure.MissionKind;
import org.dronemap.proxy.mavlink.procedure.MissionUpload;
import org.dronemap.proxy.mavlink.procedure.Sequence;
import org.dronemap.proxy.mavlink.procedure.Stage;

/** Fences and rally points: written like missions, read back and compared. */
final class FencePlans {
    private FencePlans() {}

    static Exchange readFence(Cockpit cockpit) {
        return read(cockpit, MissionKind.FENCE, items -> fenceRead(cockpit, items));
    }

    static Exchange set(Cockpit cockpit, Command.SetFence command) {
        return write(
                cockpit,
                MissionKind.FENCE,
                FenceCodec.fenceToWire(command.zones(), cockpit.target()),
                items -> fenceRead(cockpit, items));
    }

    static Exchange readRally(Cockpit cockpit) {
        return read(cockpit, MissionKind.RALLY, items -> rallyRead(cockpit, items));
    }

    static Exchange set(Cockpit cockpit, Command.SetRallyPoints command) {
        return write(
                cockpit,
                MissionKind.RALLY,
                FenceCodec.rallyToWire(command.points(), cockpit.target()),
                items -> rallyRead(cockpit, items));
    }

    private static void fenceRead(Cockpit cockpit, List<MissionItemInt> items) {
        cockpit.news().accept(new DroneEvent.FenceRead(FenceCodec.fenceFromWire(items)));
    }

    private static void rallyRead(Cockpit cockpit, List<MissionItemInt> items) {
        cockpit.news().accept(new DroneEvent.RallyPointsRead(FenceCodec.rallyFromWire(items)));
    }

    private static Exchange read(Cockpit cockpit, MissionKind kind, Consumer<List<MissionItemInt>> found) {
        MissionDownload download = MissionDownload.whole(cockpit.target(), kind, cockpit.observer());
        return new Sequence(List.of(
                Sequence.Step.of(() -> download),
                Sequence.Step.of(() -> new Conclusion(() -> {
                    found.accept(download.items());
                    return new Outcome.Succeeded();
                }))));
    }

    private static Exchange write(
            Cockpit cockpit, MissionKind kind, List<MissionItemInt> items, Consumer<List<MissionItemInt>> found) {
        int steps = 2 * items.size();
        MissionDownload readBack =
                MissionDownload.whole(cockpit.target(), kind, new Stage(cockpit.observer(), items.size(), steps));
        return new Sequence(List.of(
                Sequence.Step.of(() -> items.isEmpty()
                        ? new MissionClear(cockpit.target(), kind)
                        : new MissionUpload(cockpit.target(), kind, items, new Stage(cockpit.observer(), 0, steps))),
                Sequence.Step.of(() -> readBack),
                Sequence.Step.of(() -> new Conclusion(() -> {
                    found.accept(readBack.items());
                    return compare(items, readBack.items());
                }))));
    }

    private static Outcome compare(List<MissionItemInt> sent, List<MissionItemInt> held) {
        if (sent.size() != held.size()) {
            return new Outcome.Failed("The vehicle holds " + Counted.of(held.size(), "item") + " instead of the "
                    + sent.size() + " that were sent.");
        }
        for (int index = 0; index < sent.size(); index++) {
            if (!same(sent.get(index), held.get(index))) {
                return new Outcome.Failed("The vehicle holds item " + (index + 1) + " otherwise than it was sent.");
            }
        }
        return new Outcome.Succeeded();
    }

    private static boolean same(MissionItemInt sent, MissionItemInt held) {
        return sent.command() == held.command()
                && sent.x() == held.x()
                && sent.y() == held.y()
                && Math.abs(sent.param1() - held.param1()) < 0.05
                && Math.abs(sent.z() - held.z()) < 0.05;
    }
}
