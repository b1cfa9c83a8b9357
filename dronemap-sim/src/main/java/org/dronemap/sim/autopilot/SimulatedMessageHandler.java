package org.dronemap.sim.autopilot;

import java.util.function.Consumer;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GimbalManagerSetPitchyaw;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.LogRequestEnd;
import org.dronemap.mavlink.message.LogRequestList;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.MissionWritePartialList;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.Ping;
import org.dronemap.mavlink.message.RequestDataStream;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.mavlink.message.Timesync;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.TextSeverity;

/**
 * Handles the messages that a simulated vehicle receives, the same for every autopilot. Owned by the fleet's thread.
 */
final class SimulatedMessageHandler {
    private static final int RC_CHANNELS_OVERRIDE = 70;
    private static final long READINGS_MILLIS = 500;
    private final SimulatedAutopilot autopilot;
    private final int systemId;
    private final long bootedAt;
    private final Consumer<Message> out;
    private final Consumer<FlightEvent> events;
    private final SimulatedTelemetry telemetry;
    private final MessageStreams streams = new MessageStreams(SimulatedTelemetry.STREAMED);
    private final SimulatedStorageFaults alterations = new SimulatedStorageFaults();
    private final MissionProtocol missions;
    private final ParameterProtocol parameters;
    private final LogProtocol logs;
    private long readingsDue;
    private int reachedUntold = -1;
    private boolean startedUntold;

    SimulatedMessageHandler(
            SimulatedAutopilot autopilot,
            SimulatedVehicleSettings settings,
            long bootedAt,
            Consumer<Message> out,
            Consumer<FlightEvent> events) {
        this.autopilot = autopilot;
        this.systemId = settings.systemId();
        this.bootedAt = bootedAt;
        this.out = out;
        this.events = events;
        long epochMicros = settings.epochMicros() + bootedAt * 1000;
        this.telemetry = new SimulatedTelemetry(autopilot, settings.hardware(), epochMicros);
        this.missions = new MissionProtocol(autopilot, alterations, out, events);
        this.logs = new LogProtocol(systemId, out);
        this.parameters = new ParameterProtocol(autopilot, alterations, out);
        for (int id : SimulatedTelemetry.STREAMED) {
            double unasked = settings.streamHertz() < 0 ? autopilot.unaskedRate(id) : settings.streamHertz();
            streams.set(id, unasked, bootedAt);
        }
    }

    void step(long nowMillis) {
        if (nowMillis >= readingsDue) {
            readingsDue = nowMillis + READINGS_MILLIS;
            autopilot.payload().readings(nowMillis - bootedAt).forEach(out);
        }
        if (reachedUntold >= 0) {
            out.accept(new MissionItemReached(reachedUntold));
            reachedUntold = -1;
        }
        if (startedUntold) {
            startedUntold = false;
            out.accept(build(MissionCurrent.ID, nowMillis));
        }
        missions.step(nowMillis);
        parameters.step();
        logs.step();
        streams.sendDue(nowMillis, id -> {
            if (!telemetry.isSilent(id)) {
                out.accept(build(id, nowMillis));
            }
        });
    }

    BatteryReports batteries() {
        return telemetry.batteries();
    }

    SimulatedStorageFaults alterations() {
        return alterations;
    }

    Message build(int messageId, long nowMillis) {
        Message message = telemetry.build(messageId, nowMillis - bootedAt);
        if (message == null) {
            throw new IllegalStateException("no such message in telemetry: " + messageId);
        }
        return message;
    }

    void started(FlightEvent.ItemStarted started) {
        startedUntold = true;
        if (autopilot.missionStyle().firstItemIsHome()) {
            sendText(TextSeverity.INFO, "Mission: " + started.index() + " " + started.type());
        }
    }

    /** ArduPilot tells of the last of the items that are done at once. */
    void reached(int index) {
        if (autopilot.missionStyle().overwritesInPlace()) {
            reachedUntold = index;
        } else {
            out.accept(new MissionItemReached(index));
        }
        String text = autopilot.reachedText(index);
        if (!text.isEmpty()) {
            sendText(TextSeverity.INFO, text);
        }
    }

    private void sendText(TextSeverity severity, String text) {
        events.accept(new FlightEvent.Text(severity, text));
    }

    /** True when the vehicle has been told to reboot. */
    boolean receive(Frame frame, long nowMillis) {
        switch (frame.messageId()) {
            case CommandLong.ID -> {
                CommandLong command = CommandLong.decode(frame);
                return isForMe(command.targetSystem(), command.targetComponent())
                        && execute(MavCommand.of(command), frame, nowMillis);
            }
            case CommandInt.ID -> {
                CommandInt command = CommandInt.decode(frame);
                return isForMe(command.targetSystem(), command.targetComponent())
                        && execute(MavCommand.of(command), frame, nowMillis);
            }
            case SetMode.ID -> setMode(SetMode.decode(frame), frame);
            case SetPositionTargetGlobalInt.ID -> {
                SetPositionTargetGlobalInt target = SetPositionTargetGlobalInt.decode(frame);
                if (isMine(target.targetSystem(), target.targetComponent())) {
                    autopilot.steer(target);
                }
            }
            case SetPositionTargetLocalNed.ID -> {
                SetPositionTargetLocalNed target = SetPositionTargetLocalNed.decode(frame);
                if (isMine(target.targetSystem(), target.targetComponent())) {
                    autopilot.steer(target);
                }
            }
            case GimbalManagerSetPitchyaw.ID ->
                autopilot.payload().point(GimbalManagerSetPitchyaw.decode(frame), systemId);
            case ManualControl.ID -> manual(ManualControl.decode(frame), frame.systemId());
            case RC_CHANNELS_OVERRIDE -> stick(frame);
            default -> {
                if (!receiveMission(frame, nowMillis) && !receiveParameter(frame) && !receiveLog(frame)) {
                    receiveLink(frame, nowMillis);
                }
            }
        }
        return false;
    }

    private boolean isForMe(int targetSystem, int targetComponent) {
        return isMine(targetSystem, autopilot.heedsEveryComponent() ? 1 : targetComponent);
    }

    private boolean isMine(int targetSystem, int targetComponent) {
        return (targetSystem == systemId || targetSystem == 0) && (targetComponent == 0 || targetComponent == 1);
    }

    private void manual(ManualControl sticks, int fromSystem) {
        if (sticks.target() == systemId) {
            autopilot.manual(sticks, fromSystem);
        }
    }

    private void stick(Frame frame) {
        int throttle = frame.u16(4);
        if (frame.u8(16) == systemId && throttle >= 900 && throttle <= 2200) {
            autopilot.stick(throttle);
        }
    }

    private void setMode(SetMode message, Frame frame) {
        if (!isMine(message.targetSystem(), 0)) {
            return;
        }
        SimulatedCommandResult result = autopilot.setMode(message.baseMode(), message.customMode());
        if (autopilot.acknowledgesSetMode()) {
            acknowledge(SetMode.ID, result, frame);
        }
    }

    private void acknowledge(int command, SimulatedCommandResult result, Frame frame) {
        out.accept(new CommandAck(command, result.number(), 0, 0, frame.systemId(), frame.componentId()));
    }

    private boolean execute(MavCommand order, Frame frame, long nowMillis) {
        SimulatedCommandResult result = switch (order.command()) {
            case MavCmd.SET_MESSAGE_INTERVAL -> setInterval(order, nowMillis);
            case MavCmd.REQUEST_MESSAGE ->
                SimulatedCommandResult.acceptedIf(telemetry.build((int) order.param1(), 0) != null);
            case MavCmd.REQUEST_CAPABILITIES, MavCmd.GET_HOME_POSITION -> SimulatedCommandResult.ACCEPTED;
            case MavCmd.REBOOT ->
                SimulatedCommandResult.acceptedIf(!autopilot.craft().armed());
            default -> autopilot.execute(order);
        };
        acknowledge(order.command(), result, frame);
        if (result == SimulatedCommandResult.ACCEPTED) {
            sendRequested(order, nowMillis);
        }
        return result == SimulatedCommandResult.ACCEPTED && order.command() == MavCmd.REBOOT && order.param1() == 1;
    }

    private void sendRequested(MavCommand order, long nowMillis) {
        switch (order.command()) {
            case MavCmd.REQUEST_MESSAGE -> out.accept(build((int) order.param1(), nowMillis));
            case MavCmd.REQUEST_CAPABILITIES -> out.accept(build(AutopilotVersion.ID, nowMillis));
            case MavCmd.GET_HOME_POSITION -> out.accept(build(HomePosition.ID, nowMillis));
            case MavCmd.SET_MISSION_CURRENT -> out.accept(build(MissionCurrent.ID, nowMillis));
            default -> {}
        }
    }

    private SimulatedCommandResult setInterval(MavCommand order, long nowMillis) {
        int id = (int) order.param1();
        double micros = order.param2();
        double hertz = micros > 0 ? 1e6 / micros : 0;
        if (micros == 0) {
            hertz = autopilot.unaskedRate(id);
        }
        boolean known = streams.set(id, hertz, nowMillis) || id == Heartbeat.ID || micros <= 0;
        return known ? SimulatedCommandResult.ACCEPTED : autopilot.refuseInterval(id);
    }

    private boolean receiveMission(Frame frame, long nowMillis) {
        int fromSystem = frame.systemId();
        int fromComponent = frame.componentId();
        switch (frame.messageId()) {
            case MissionCount.ID -> {
                MissionCount count = MissionCount.decode(frame);
                if (isMine(count.targetSystem(), count.targetComponent())) {
                    missions.count(count, fromSystem, fromComponent, nowMillis);
                }
            }
            case MissionItemInt.ID -> receiveItem(MissionItemInt.decode(frame), frame, nowMillis);
            case MissionItem.ID -> receiveItem(FloatMissionItems.toInt(MissionItem.decode(frame)), frame, nowMillis);
            case MissionRequestList.ID -> {
                MissionRequestList request = MissionRequestList.decode(frame);
                if (isMine(request.targetSystem(), request.targetComponent())) {
                    missions.sendCount(request.missionType(), fromSystem, fromComponent);
                }
            }
            case MissionRequestInt.ID -> answerItemRequest(MissionRequestInt.decode(frame), false, frame);
            case MissionRequest.ID -> {
                MissionRequest old = MissionRequest.decode(frame);
                var request =
                        new MissionRequestInt(old.targetSystem(), old.targetComponent(), old.seq(), old.missionType());
                answerItemRequest(request, true, frame);
            }
            case MissionClearAll.ID -> {
                MissionClearAll clear = MissionClearAll.decode(frame);
                if (isMine(clear.targetSystem(), clear.targetComponent())) {
                    missions.clear(clear.missionType(), fromSystem, fromComponent);
                }
            }
            case MissionWritePartialList.ID -> receivePart(MissionWritePartialList.decode(frame), frame, nowMillis);
            case MissionSetCurrent.ID -> setCurrent(MissionSetCurrent.decode(frame), nowMillis);
            default -> {
                return false;
            }
        }
        return true;
    }

    private void receiveItem(MissionItemInt item, Frame frame, long nowMillis) {
        if (isMine(item.targetSystem(), item.targetComponent())) {
            missions.item(item, frame.systemId(), nowMillis);
        }
    }

    private void receivePart(MissionWritePartialList part, Frame frame, long nowMillis) {
        if (isMine(part.targetSystem(), part.targetComponent())) {
            missions.writePart(part, frame.systemId(), frame.componentId(), nowMillis);
        }
    }

    private void answerItemRequest(MissionRequestInt request, boolean inFloats, Frame frame) {
        if (isMine(request.targetSystem(), request.targetComponent())) {
            missions.sendItem(request, inFloats, frame.systemId(), frame.componentId());
        }
    }

    private void setCurrent(MissionSetCurrent message, long nowMillis) {
        if (isMine(message.targetSystem(), message.targetComponent()) && autopilot.setCurrentItem(message.seq())) {
            out.accept(build(MissionCurrent.ID, nowMillis));
        }
    }

    private boolean receiveParameter(Frame frame) {
        switch (frame.messageId()) {
            case ParamRequestList.ID -> {
                ParamRequestList request = ParamRequestList.decode(frame);
                if (isMine(request.targetSystem(), request.targetComponent())) {
                    parameters.list();
                }
            }
            case ParamRequestRead.ID -> {
                ParamRequestRead request = ParamRequestRead.decode(frame);
                if (isMine(request.targetSystem(), request.targetComponent())) {
                    parameters.read(request);
                }
            }
            case ParamSet.ID -> {
                ParamSet request = ParamSet.decode(frame);
                if (isMine(request.targetSystem(), request.targetComponent())) {
                    parameters.write(request);
                }
            }
            default -> {
                return false;
            }
        }
        return true;
    }

    private boolean receiveLog(Frame frame) {
        switch (frame.messageId()) {
            case LogRequestList.ID -> {
                LogRequestList request = LogRequestList.decode(frame);
                if (isMine(request.targetSystem(), request.targetComponent())) {
                    logs.list(request);
                }
            }
            case LogRequestData.ID -> {
                LogRequestData request = LogRequestData.decode(frame);
                if (isMine(request.targetSystem(), request.targetComponent())) {
                    logs.sendBlock(request);
                }
            }
            case LogRequestEnd.ID -> logs.stop();
            default -> {
                return false;
            }
        }
        return true;
    }

    private void receiveLink(Frame frame, long nowMillis) {
        switch (frame.messageId()) {
            case RequestDataStream.ID -> {
                RequestDataStream request = RequestDataStream.decode(frame);
                if (isMine(request.targetSystem(), request.targetComponent())) {
                    double hertz = request.startStop() == 0 ? 0 : request.reqMessageRate();
                    streams.setGroup(request.reqStreamId(), hertz, nowMillis);
                }
            }
            case Timesync.ID -> {
                Timesync question = Timesync.decode(frame);
                if (question.tc1() == 0) {
                    out.accept(
                            new Timesync(nowMillis * 1_000_000, question.ts1(), frame.systemId(), frame.componentId()));
                }
            }
            case Ping.ID -> {
                Ping ping = Ping.decode(frame);
                if (ping.targetSystem() == 0 || ping.targetSystem() == systemId) {
                    out.accept(new Ping(ping.timeUsec(), ping.seq(), frame.systemId(), frame.componentId()));
                }
            }
            default -> {}
        }
    }
}
