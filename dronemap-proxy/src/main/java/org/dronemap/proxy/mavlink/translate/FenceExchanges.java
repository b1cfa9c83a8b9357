package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.function.Consumer;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.CountText;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MissionClear;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.dronemap.proxy.mavlink.procedure.MissionUpload;
import org.dronemap.proxy.mavlink.procedure.StepProgressObserver;

/** Makes the exchanges that upload fences and rally points to a vehicle, or read them back and compare them. */
final class FenceExchanges {
    private FenceExchanges() {}

    static Exchange readFence(CommandContext cockpit) {
        return read(cockpit, MavMissionType.FENCE, items -> fenceRead(cockpit, items));
    }

    static Exchange set(CommandContext cockpit, Command.SetFence command) {
        return write(
                cockpit,
                MavMissionType.FENCE,
                FenceCodec.fenceToWire(command.zones(), cockpit.target()),
                items -> fenceRead(cockpit, items));
    }

    static Exchange readRally(CommandContext cockpit) {
        return read(cockpit, MavMissionType.RALLY, items -> rallyRead(cockpit, items));
    }

    static Exchange set(CommandContext cockpit, Command.SetRallyPoints command) {
        return write(
                cockpit,
                MavMissionType.RALLY,
                FenceCodec.rallyToWire(command.points(), cockpit.target()),
                items -> rallyRead(cockpit, items));
    }

    private static void fenceRead(CommandContext cockpit, List<MissionItemInt> items) {
        cockpit.news().accept(new DroneEvent.FenceRead(FenceCodec.fenceFromWire(items)));
    }

    private static void rallyRead(CommandContext cockpit, List<MissionItemInt> items) {
        cockpit.news().accept(new DroneEvent.RallyPointsRead(FenceCodec.rallyFromWire(items)));
    }

    private static Exchange read(CommandContext cockpit, MavMissionType kind, Consumer<List<MissionItemInt>> found) {
        MissionDownload download = MissionDownload.whole(cockpit.target(), kind, cockpit.observer());
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> download),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    found.accept(download.items());
                    return new Outcome.Succeeded();
                }))));
    }

    private static Exchange write(
            CommandContext cockpit,
            MavMissionType kind,
            List<MissionItemInt> items,
            Consumer<List<MissionItemInt>> found) {
        int steps = 2 * items.size();
        MissionDownload readBack = MissionDownload.whole(
                cockpit.target(), kind, new StepProgressObserver(cockpit.observer(), items.size(), steps));
        MissionUpload upload = new MissionUpload(
                cockpit.target(), kind, items, new StepProgressObserver(cockpit.observer(), 0, steps));
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> items.isEmpty() ? new MissionClear(cockpit.target(), kind) : upload),
                ExchangeSequence.Step.of(() -> readBack),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    found.accept(readBack.items());
                    return compare(upload.taken(), readBack.items());
                }))));
    }

    private static Outcome compare(List<MissionItemInt> sent, List<MissionItemInt> held) {
        if (sent.size() != held.size()) {
            return new Outcome.Failed("The vehicle holds " + CountText.of(held.size(), "item") + " instead of the "
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
