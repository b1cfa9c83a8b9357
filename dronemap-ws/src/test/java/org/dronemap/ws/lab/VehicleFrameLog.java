package org.dronemap.ws.lab;

import java.util.List;
import java.util.Set;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.RequestDataStream;
import org.dronemap.mavlink.message.Timesync;

/** All frames on a vehicle's wire from now on. */
public final class VehicleFrameLog {
    private static final int PING = 4;
    private static final int SET_MESSAGE_INTERVAL = 511;
    private static final int REQUEST_MESSAGE = 512;

    /** Messages that the cloud sends to vehicles by itself, whoever looks on. */
    private static final Set<Integer> OWN = Set.of(
            Heartbeat.ID,
            Timesync.ID,
            PING,
            MissionRequestList.ID,
            MissionRequestInt.ID,
            MissionAck.ID,
            RequestDataStream.ID,
            ParamRequestRead.ID);

    private static final Set<Integer> OWN_COMMANDS = Set.of(SET_MESSAGE_INTERVAL, REQUEST_MESSAGE);

    private final LinkTap tap;

    public VehicleFrameLog(LabDrone drone) {
        tap = drone.wire().tap();
    }

    /** What it said of that kind. */
    public List<Frame> said(int message) {
        return tap.said(message, frame -> frame);
    }

    /** What it was told of that kind. */
    public List<Frame> told(int message) {
        return tap.told(message, frame -> frame);
    }

    /** What it was told beside what the cloud says anyhow: messages by their numbers, and commands by theirs. */
    public List<String> told() {
        return tap.all().stream()
                .filter(one -> !one.up())
                .map(LinkTap.Heard::frame)
                .filter(frame -> !isOwn(frame))
                .map(VehicleFrameLog::name)
                .toList();
    }

    private static boolean isOwn(Frame frame) {
        int command = command(frame);
        return command < 0 ? OWN.contains(frame.messageId()) : OWN_COMMANDS.contains(command);
    }

    /** -1 for another message. */
    private static int command(Frame frame) {
        return switch (frame.messageId()) {
            case CommandLong.ID -> CommandLong.decode(frame).command();
            case CommandInt.ID -> CommandInt.decode(frame).command();
            default -> -1;
        };
    }

    private static String name(Frame frame) {
        int command = command(frame);
        return command < 0 ? "message " + frame.messageId() : "command " + command;
    }
}
