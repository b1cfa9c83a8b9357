package org.dronemap.proxy.outlet.uplink;

import java.util.Map;
import java.util.Set;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.FileTransferProtocol;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.LogRequestList;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.Ping;
import org.dronemap.mavlink.message.RcChannelsOverride;
import org.dronemap.mavlink.message.RequestDataStream;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.mavlink.message.SystemTime;
import org.dronemap.mavlink.message.Timesync;
import org.dronemap.proxy.outlet.client.ClientMessage;
import org.dronemap.proxy.outlet.client.OutletClient;
import org.dronemap.proxy.outlet.client.OutletCounts;

/**
 * Dispatches the messages of ground stations at the outlet to their handlers; unknown kinds are ignored. No frame goes
 * on to a vehicle. Owned by the outlet's thread.
 */
public final class ClientMessageDispatcher implements AutoCloseable {
    /** Heard, and nothing more: signs of life, and what is as wanted already. */
    static final Set<Integer> HEARD =
            Set.of(Heartbeat.ID, SystemTime.ID, RequestDataStream.ID, MissionAck.ID, CommandAck.ID);

    private static final String LOGS =
            "Logs on board and recordings of flights are fetched from the server's page, not here.";

    private static final int SET_ATTITUDE_TARGET = 82;
    private static final int SET_ACTUATOR_CONTROL_TARGET = 139;
    private static final String NO_ATTITUDES =
            "Attitudes and actuators are not steered through the cloud; steer by sticks, speeds or places.";

    /** What is done otherwise than by these messages. */
    private static final Map<Integer, String> ELSEWHERE = Map.of(
            LogRequestList.ID,
            LOGS,
            LogRequestData.ID,
            LOGS,
            MissionSetCurrent.ID,
            "The item to go on from is not set through the cloud; upload the mission from there on.",
            SET_ATTITUDE_TARGET,
            NO_ATTITUDES,
            SET_ACTUATOR_CONTROL_TARGET,
            NO_ATTITUDES);

    private static final long BETWEEN_SENTENCES_NANOS = 10_000_000_000L;

    private final OutletCounts counts;
    private final Map<DroneId, VehicleFrameCache> vehicles;
    private final ClientCommandExecutor orders;
    private final ClientControlHandler controls;
    private final ControlStatusPublisher news;
    private final ClientCommandHandler commands;
    private final ClientParameterHandler parameters;
    private final ClientMissionReadHandler missions;
    private final ClientMissionWriteHandler intake;
    private final ClientSteeringHandler steering;

    public ClientMessageDispatcher(
            CloudManager cloud,
            OutletLeaseAuthority control,
            OutletCounts counts,
            Map<DroneId, VehicleFrameCache> vehicles,
            AttachedClients attached,
            Time time) {
        this.counts = counts;
        this.vehicles = vehicles;
        orders = new ClientCommandExecutor(cloud, control, attached::later, time);
        controls = new ClientControlHandler(cloud, orders);
        news = new ControlStatusPublisher(cloud, vehicles, attached);
        commands = new ClientCommandHandler(cloud, orders, controls);
        parameters = new ClientParameterHandler(cloud, orders);
        missions = new ClientMissionReadHandler(cloud, orders);
        intake = new ClientMissionWriteHandler(cloud, orders);
        steering = new ClientSteeringHandler(cloud, orders);
    }

    public void dispatch(OutletClient client, Frame frame, long now) {
        int message = frame.messageId();
        if (message == Heartbeat.ID) {
            controls.alive(client);
        }
        if (HEARD.contains(message)) {
            return;
        }
        if (message == Timesync.ID || message == Ping.ID) {
            time(client, frame, now);
            return;
        }
        int target = target(frame);
        DroneId drone = target == 0 ? null : client.drone(target);
        VehicleFrameCache vehicle = drone == null ? null : vehicles.get(drone);
        if (drone == null || vehicle == null || !serve(new ClientRequest(client, drone, vehicle, frame), now)) {
            counts.notPassed();
        }
    }

    /** The system that it is for; 0: none. */
    private static int target(Frame frame) {
        if (frame.messageId() == ManualControl.ID) {
            return ManualControl.decode(frame).target();
        }
        MessageTable.Entry entry = MessageTable.find(frame.messageId());
        return entry == null || entry.targetOffset() < 0 ? 0 : frame.u8(entry.targetOffset());
    }

    /** False for what has no effect. */
    private boolean serve(ClientRequest asked, long now) {
        switch (asked.frame().messageId()) {
            case CommandLong.ID, CommandInt.ID, SetMode.ID -> commands.handle(asked, now);
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
            case FileTransferProtocol.ID -> FtpRefusalHandler.handle(asked);
            case ManualControl.ID, RcChannelsOverride.ID, SetPositionTargetLocalNed.ID, SetPositionTargetGlobalInt.ID ->
                steering.handle(asked, now);
            default -> {
                explain(asked, now);
                return false;
            }
        }
        return true;
    }

    /** An item that stands for itself is where the vehicle is to go now. */
    private void olderItem(ClientRequest asked, long now) {
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
                client.enqueue(new ClientMessage.OfCloud(
                        new Ping(ping.timeUsec(), ping.seq(), frame.systemId(), frame.componentId())));
            }
            return;
        }
        Timesync question = Timesync.decode(frame);
        if (question.tc1() == 0) {
            client.enqueue(new ClientMessage.OfCloud(
                    new Timesync(now, question.ts1(), frame.systemId(), frame.componentId())));
        }
    }

    /** None can be fetched here; who asks is told so at once, and where they are. */
    private static void logs(ClientRequest asked) {
        asked.answer(new LogEntry(0, 0, 0, 0, 0));
        asked.explain(LOGS);
    }

    /** Says why nothing comes of it, and not again at once. */
    private static void explain(ClientRequest asked, long now) {
        String why = ELSEWHERE.get(asked.frame().messageId());
        if (why != null && asked.client().mayExplain(why, now, BETWEEN_SENTENCES_NANOS)) {
            asked.explain(why);
        }
    }

    /** Tells what is told once a second. */
    public void second() {
        news.publishAll();
    }

    /** Goes on with what takes longer. */
    public void advance(long now) {
        parameters.serve();
        intake.advance(now);
    }

    /** The client has gone. */
    public void forget(OutletClient client) {
        controls.forget(client.id());
        parameters.forget(client.id());
        missions.forget(client.id());
        intake.forget(client.id());
        steering.forget(client.id());
    }

    @Override
    public void close() {
        news.close();
        orders.close();
    }
}
