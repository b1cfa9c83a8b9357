package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.function.Function;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.drone.OnboardRallyPoints;
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

    static Exchange set(CommandContext cockpit, SetFence command) {
        return write(
                cockpit,
                MavMissionType.FENCE,
                FenceCodec.fenceToWire(command, cockpit.target()),
                items -> fenceRead(cockpit, items));
    }

    static Exchange readRally(CommandContext cockpit) {
        return read(cockpit, MavMissionType.RALLY, items -> rallyRead(cockpit, items));
    }

    static Exchange set(CommandContext cockpit, SetRallyPoints command) {
        return write(
                cockpit,
                MavMissionType.RALLY,
                FenceCodec.rallyToWire(command.points(), cockpit.target()),
                items -> rallyRead(cockpit, items));
    }

    /** The same for a vehicle that keeps heights of rally points in whole metres (ArduPilot) and would round others. */
    static Exchange setWholeMeters(CommandContext cockpit, SetRallyPoints command) {
        for (int index = 0; index < command.points().size(); index++) {
            double meters = command.points().get(index).altitudeMeters();
            if (meters != Math.rint(meters)) {
                return BasicExchanges.refuse(
                        OutcomeCode.MISSION_VALUE_NOT_TAKEN,
                        "This vehicle keeps heights of rally points in whole metres: rally point " + (index + 1)
                                + " cannot be at " + meters + " m.");
            }
        }
        return set(cockpit, command);
    }

    /** What of it cannot be told, each as a sentence. */
    private static List<String> fenceRead(CommandContext cockpit, List<MissionItemInt> items) {
        OnboardFence fence = FenceCodec.fenceFromWire(items);
        cockpit.news().accept(new DroneEvent.FenceRead(fence));
        return fence.leftOut();
    }

    private static List<String> rallyRead(CommandContext cockpit, List<MissionItemInt> items) {
        OnboardRallyPoints points = FenceCodec.rallyFromWire(items);
        cockpit.news().accept(new DroneEvent.RallyPointsRead(points));
        return points.leftOut();
    }

    /** Whoever reads only a part must not take it for the whole: so what is left out is no success. */
    private static Outcome read(List<String> leftOut) {
        return leftOut.isEmpty()
                ? new Outcome.Succeeded()
                : new Outcome.Failed("It was read, but not all that the vehicle has can be shown. Left out: "
                        + String.join(" ", leftOut));
    }

    private static Exchange read(
            CommandContext cockpit, MavMissionType kind, Function<List<MissionItemInt>, List<String>> found) {
        MissionDownload download = MissionDownload.whole(cockpit.target(), kind, cockpit.observer());
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> download),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> read(found.apply(download.items()))))));
    }

    private static Exchange write(
            CommandContext cockpit,
            MavMissionType kind,
            List<MissionItemInt> items,
            Function<List<MissionItemInt>, List<String>> found) {
        int steps = 2 * items.size();
        MissionDownload readBack = MissionDownload.whole(
                cockpit.target(), kind, new StepProgressObserver(cockpit.observer(), items.size(), steps));
        MissionUpload upload = new MissionUpload(
                        cockpit.target(), kind, items, new StepProgressObserver(cockpit.observer(), 0, steps))
                .withIntegerItems(cockpit.status().knowsIntegerItems());
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> items.isEmpty() ? new MissionClear(cockpit.target(), kind) : upload),
                ExchangeSequence.Step.of(() -> readBack),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    Outcome read = read(found.apply(readBack.items()));
                    Outcome compared = compare(upload.acceptedItems(), readBack.items());
                    return compared instanceof Outcome.Succeeded ? read : compared;
                }))));
    }

    private static Outcome compare(List<MissionItemInt> sent, List<MissionItemInt> held) {
        if (sent.size() != held.size()) {
            return new Outcome.Failed("The vehicle holds " + CountText.of(held.size(), "item") + " instead of the "
                    + sent.size() + " that were sent.");
        }
        for (int index = 0; index < sent.size(); index++) {
            String otherwise = FenceItemComparison.difference(sent.get(index), held.get(index));
            if (otherwise != null) {
                return new Outcome.Failed(
                        "The vehicle holds item " + (index + 1) + " otherwise than it was sent: " + otherwise + ".");
            }
        }
        return new Outcome.Succeeded();
    }
}
