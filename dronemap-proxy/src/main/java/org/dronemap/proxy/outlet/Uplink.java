package org.dronemap.proxy.outlet;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.FileTransferProtocol;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestList;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.Ping;
import org.dronemap.mavlink.message.RequestDataStream;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SystemTime;
import org.dronemap.mavlink.message.Timesync;

/**
 * What becomes of the messages of clients, by kind; no kind that is not named here has any effect. No frame goes on to a
 * vehicle. Owned by the outlet's thread.
 */
final class Uplink implements AutoCloseable {
    /** Heard, and nothing more: signs of life, and what is as wanted already. */
    static final Set<Integer> HEARD = Set.of(Heartbeat.ID, SystemTime.ID, RequestDataStream.ID, MissionAck.ID);

    /** Sticks and setpoints, which do not pass, and say so. */
    static final Set<Integer> STEERING = Set.of(69, 70, 82, 84, 86, 139);

    private static final long BETWEEN_SENTENCES_NANOS = 10_000_000_000L;

    private final OutletCounts counts;
    private final Map<DroneId, VehicleTap> vehicles;
    private final CloudManager cloud;
    private final Orders orders;
    private final CommandCounter commands;
    private final ParameterCounter parameters;
    private final MissionCounter missions;
    private final MissionIntake intake;

    Uplink(CloudManager cloud, OutletCounts counts, Map<DroneId, VehicleTap> vehicles, Consumer<Runnable> tasks) {
        this.cloud = cloud;
        this.counts = counts;
        this.vehicles = vehicles;
        orders = new Orders(cloud, tasks);
        commands = new CommandCounter(cloud, orders);
        parameters = new ParameterCounter(cloud, orders);
        missions = new MissionCounter(cloud, orders);
        intake = new MissionIntake(cloud, orders);
    }

    void take(OutletClient client, Frame frame, long now) {
        int message = frame.messageId();
        if (HEARD.contains(message)) {
            return;
        }
        if (message == Timesync.ID || message == Ping.ID) {
            time(client, frame, now);
            return;
        }
        MessageTable.Entry entry = MessageTable.find(message);
        int target = entry == null || entry.targetOffset() < 0 ? 0 : frame.u8(entry.targetOffset());
        DroneId drone = target == 0 ? null : client.drone(target);
        VehicleTap vehicle = drone == null ? null : vehicles.get(drone);
        if (drone == null || vehicle == null || !serve(new Asked(client, drone, vehicle, frame), now)) {
            counts.notPassed();
        }
    }

    /** False for what has no effect. */
    private boolean serve(Asked asked, long now) {
        switch (asked.frame().messageId()) {
            case CommandLong.ID, CommandInt.ID, SetMode.ID -> commands.take(asked, now);
            case ParamRequestList.ID -> parameters.list(asked);
            case ParamRequestRead.ID -> parameters.read(asked);
            case ParamSet.ID -> parameters.set(asked);
            case MissionRequestList.ID -> missions.list(asked);
            case MissionRequestInt.ID -> missions.item(asked);
            case MissionRequest.ID -> missions.olderItem(asked);
            case MissionCount.ID -> intake.begin(asked, now);
            case MissionItemInt.ID -> intake.item(asked, now);
            case MissionItem.ID -> olderItem(asked, now);
            case MissionClearAll.ID -> intake.clear(asked, now);
            case LogRequestList.ID -> logs(asked);
            case FileTransferProtocol.ID -> FileCounter.take(asked);
            default -> {
                if (STEERING.contains(asked.frame().messageId())
                        && asked.client().mayHearOfSteering(now, BETWEEN_SENTENCES_NANOS)) {
                    asked.explain("Sticks and setpoints do not pass the cloud; use modes, go-to and missions.");
                }
                return false;
            }
        }
        return true;
    }

    /** An item that stands for itself is where the vehicle is to go now. */
    private void olderItem(Asked asked, long now) {
        if (MissionItem.decode(asked.frame()).current() == 2) {
            commands.goTo(asked);
        } else {
            intake.olderItem(asked, now);
        }
    }

    private void time(OutletClient client, Frame frame, long now) {
        if (frame.messageId() == Ping.ID) {
            Ping ping = Ping.decode(frame);
            if (ping.targetSystem() == 0) {
                client.say(new Letter.OfCloud(
                        new Ping(ping.timeUsec(), ping.seq(), frame.systemId(), frame.componentId())));
            }
            return;
        }
        Timesync question = Timesync.decode(frame);
        if (question.tc1() == 0) {
            client.say(new Letter.OfCloud(new Timesync(now, question.ts1(), frame.systemId(), frame.componentId())));
        }
    }

    /** What the cloud knows of the logs on board; one that says nothing stands for none. */
    private void logs(Asked asked) {
        List<VehicleLog> known = cloud.onBoard(asked.drone()).logs();
        List<VehicleLog> logs = known == null ? List.of() : known;
        int last = logs.stream().mapToInt(VehicleLog::number).max().orElse(0);
        if (logs.isEmpty()) {
            asked.answer(new LogEntry(0, 0, 0, 0, 0));
        }
        for (VehicleLog log : logs) {
            long at = log.at() == null ? 0 : log.at().getEpochSecond();
            asked.answer(new LogEntry(log.number(), logs.size(), last, at, log.sizeBytes()));
        }
    }

    /** Goes on with what takes longer. */
    void tick(long now) {
        parameters.serve();
        intake.tick(now);
    }

    /** The client has gone. */
    void forget(OutletClient client) {
        parameters.forget(client.id());
        missions.forget(client.id());
        intake.forget(client.id());
    }

    @Override
    public void close() {
        orders.close();
    }
}
