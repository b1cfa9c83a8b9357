package org.dronemap.proxy.mavlink.procedure;

import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.GpsRawInt;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.RequestDataStream;
import org.dronemap.mavlink.message.ServoOutputRaw;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.VfrHud;

/**
 * Asks a MAVLink vehicle for the telemetry messages that the cloud needs, again when they stop or were refused. Owned
 * by the drone's lane.
 */
public final class MessageRateRequester {
    private static final int SET_MESSAGE_INTERVAL = 511;
    private static final long PACE_NANOS = 40_000_000L;
    private static final long SOON_NANOS = 3_000_000_000L;
    private static final long LATER_NANOS = 30_000_000_000L;
    private static final int EAGER_ASKS = 4;
    private static final int ASKS_BEFORE_OLD_WAY = 2;
    private static final int[][] OLD_STREAMS_WITH_HERTZ = {{2, 1}, {6, 4}, {10, 4}, {11, 4}, {12, 1}};

    private final MavlinkTarget target;
    private final Map<Integer, Stream> streams = new LinkedHashMap<>();
    private boolean newWayUnknown;
    private long lastSentNanos;
    private long lastOldWayNanos;
    private boolean oldWayAsked;

    private static final class Stream {
        private final long intervalMicros;
        private long receivedNanos;
        private long askedNanos;
        private boolean everReceived;
        private int asks;

        Stream(long intervalMicros) {
            this.intervalMicros = intervalMicros;
        }

        boolean wanting(long nowNanos) {
            if (asks == 0) {
                return true;
            }
            long normal = Math.max(3 * intervalMicros * 1000, SOON_NANOS);
            boolean silent = !everReceived || nowNanos - receivedNanos > normal;
            return silent && nowNanos - askedNanos > (asks < EAGER_ASKS ? SOON_NANOS : LATER_NANOS);
        }
    }

    public MessageRateRequester(MavlinkTarget target) {
        this.target = target;
        streams.put(GlobalPositionInt.ID, new Stream(250_000));
        streams.put(Attitude.ID, new Stream(250_000));
        streams.put(VfrHud.ID, new Stream(250_000));
        streams.put(SysStatus.ID, new Stream(1_000_000));
        streams.put(ExtendedSysState.ID, new Stream(1_000_000));
        streams.put(GpsRawInt.ID, new Stream(1_000_000));
        streams.put(MissionCurrent.ID, new Stream(1_000_000));
        streams.put(ServoOutputRaw.ID, new Stream(1_000_000));
        streams.put(BatteryStatus.ID, new Stream(2_000_000));
        streams.put(HomePosition.ID, new Stream(5_000_000));
    }

    /** Something that vehicles of one family tell and others do not know. */
    public void also(int messageId, long intervalMicros) {
        streams.put(messageId, new Stream(intervalMicros));
    }

    public void received(Frame frame, long nowNanos) {
        Stream stream = streams.get(frame.messageId());
        if (stream != null) {
            stream.receivedNanos = nowNanos;
            stream.everReceived = true;
        } else if (frame.messageId() == CommandAck.ID) {
            CommandAck ack = CommandAck.decode(frame);
            boolean ours = ack.command() == SET_MESSAGE_INTERVAL && MavlinkTarget.isForUs(ack.targetSystem());
            // One message alone may be unknown too; the old way comes when nothing at all was ever heard.
            newWayUnknown |= ours
                    && ack.result() == MavResult.UNSUPPORTED
                    && streams.values().stream().noneMatch(any -> any.everReceived);
        }
    }

    public void advance(long nowNanos) {
        if (nowNanos - lastSentNanos < PACE_NANOS) {
            return;
        }
        if (oldWayDue(nowNanos)) {
            lastOldWayNanos = nowNanos;
            oldWayAsked = true;
            lastSentNanos = nowNanos;
            for (int[] stream : OLD_STREAMS_WITH_HERTZ) {
                target.send(new RequestDataStream(target.systemId(), target.componentId(), stream[0], stream[1], 1));
            }
            return;
        }
        for (Map.Entry<Integer, Stream> entry : streams.entrySet()) {
            if (entry.getValue().wanting(nowNanos)) {
                ask(entry.getKey(), entry.getValue(), nowNanos);
                return;
            }
        }
    }

    private boolean oldWayDue(long nowNanos) {
        Stream position = streams.get(GlobalPositionInt.ID);
        Stream attitude = streams.get(Attitude.ID);
        if (position == null || attitude == null) {
            return false;
        }
        boolean silent = !flows(position, nowNanos) && !flows(attitude, nowNanos);
        boolean askedInVain = position.asks > ASKS_BEFORE_OLD_WAY;
        return silent && (newWayUnknown || askedInVain) && (!oldWayAsked || nowNanos - lastOldWayNanos > LATER_NANOS);
    }

    private static boolean flows(Stream stream, long nowNanos) {
        return stream.everReceived && nowNanos - stream.receivedNanos < SOON_NANOS;
    }

    private void ask(int messageId, Stream stream, long nowNanos) {
        stream.asks++;
        stream.askedNanos = nowNanos;
        lastSentNanos = nowNanos;
        target.send(new CommandLong(
                target.systemId(),
                target.componentId(),
                SET_MESSAGE_INTERVAL,
                0,
                messageId,
                stream.intervalMicros,
                0f,
                0f,
                0f,
                0f,
                0f));
    }
}
