package org.dronemap.proxy.session;

import java.util.List;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.cloud.lane.LinkPace;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HighLatency;
import org.dronemap.mavlink.message.HighLatency2;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.CommandSendTimes;
import org.dronemap.proxy.mavlink.procedure.GimbalControl;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.procedure.MessageRateRequester;
import org.dronemap.proxy.mavlink.procedure.TimesyncResponder;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.CommandContext;
import org.dronemap.proxy.mavlink.translate.ParameterTable;
import org.dronemap.proxy.mavlink.translate.TelemetryTranslator;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;
import org.dronemap.proxy.mavlink.translate.VehicleType;

/**
 * The server's message exchange with one autopilot over any of its links: telemetry, heartbeats, commands. Owned by the
 * lane of its session.
 */
final class AutopilotChannel {
    /**
     * ArduPilot goes home after five seconds without one. At one a second, a link that loses every tenth message would send a
     * drone home about every three hours of flight.
     */
    private static final long HEARTBEAT_NANOS = 500_000_000L;

    private static final int REQUEST_MESSAGE = 512;
    static final Heartbeat OWN_HEARTBEAT = new Heartbeat(6, 8, 0, 0, 4, 3);

    private final LinkSelector links;
    private final Consumer<DroneEvent> news;
    private final LongSupplier nanoTime;
    private final MavlinkTarget target;
    private final int family;
    private AutopilotAdapter autopilot;
    private final VehicleStatus status;
    private final TelemetryTranslator telemetry;
    private final ParameterTable parameters;
    private final ActiveCommands errands = new ActiveCommands();
    private final MessageRateRequester rates;
    private final MissionWatch missions;
    private final TimesyncResponder time;
    private final GimbalControl gimbal;
    private final LinkPace firstPace;
    private boolean known;
    private long lastHeartbeatNanos;

    /**
     * {@code first} is, or stands for, a heartbeat of that autopilot; {@code news} hears what it says, {@code missionRead} what it keeps as
     * its mission.
     */
    AutopilotChannel(
            LinkSelector links,
            Frame first,
            Consumer<DroneEvent> news,
            Consumer<List<MissionItemInt>> missionRead,
            LongSupplier nanoTime) {
        this.links = links;
        this.news = news;
        this.nanoTime = nanoTime;
        Heartbeat heartbeat = VehicleType.announced(first).orElseThrow();
        target = new MavlinkTarget(
                first.systemId(), first.componentId(), links::send, links::roundTrip, new CommandSendTimes());
        family = heartbeat.autopilot();
        firstPace = pace(first);
        autopilot = AutopilotAdapter.of(heartbeat);
        status = new VehicleStatus(heartbeat.type(), anyNumber(nanoTime.getAsLong()));
        telemetry = new TelemetryTranslator(autopilot, status, this::publish);
        parameters = new ParameterTable(autopilot, this::publish);
        rates = new MessageRateRequester(target);
        // In one order on every machine.
        new TreeMap<>(autopilot.ownMessages()).forEach(rates::also);
        missions = new MissionWatch(target, autopilot, status, this::publish, missionRead);
        time = new TimesyncResponder(target);
        gimbal = new GimbalControl(target, links::send);
        lastHeartbeatNanos = nanoTime.getAsLong() - HEARTBEAT_NANOS;
    }

    private static int anyNumber(long nanos) {
        return (int) (nanos / 1_000_000_000L % 1_000_000);
    }

    MavlinkTarget target() {
        return target;
    }

    AutopilotAdapter autopilot() {
        return autopilot;
    }

    VehicleStatus status() {
        return status;
    }

    /** What its first frame showed of that, before anybody listened. */
    LinkPace firstPace() {
        return firstPace;
    }

    /** What a frame shows of the pace at which its vehicle speaks. */
    static LinkPace pace(Frame frame) {
        return switch (frame.messageId()) {
            case Heartbeat.ID -> LinkPace.STEADY;
            case HighLatency.ID, HighLatency2.ID -> LinkPace.SELDOM;
            default -> LinkPace.UNCHANGED;
        };
    }

    /** Another component of the vehicle said something. */
    void receivedFromComponent(Frame frame, long now) {
        gimbal.received(frame);
        telemetry.receivedFromComponent(frame, now);
    }

    /** The autopilot of a recording said something. */
    void replayed(Frame frame, long now) {
        if (frame.messageId() == ExtendedSysState.ID) {
            autopilot.typeBy(ExtendedSysState.decode(frame)).ifPresent(this::becomes);
        }
        telemetry.received(frame, now);
        parameters.received(frame);
    }

    /** Its heartbeats say less than it is. */
    private void becomes(int type) {
        status.type(type);
        autopilot = AutopilotAdapter.of(family, type);
        telemetry.becomes(autopilot);
    }

    /** The autopilot said something. */
    void received(Frame frame, long now) {
        replayed(frame, now);
        gimbal.received(frame);
        errands.received(frame, now);
        links.received(frame, now);
        if (known) {
            time.received(frame, now);
        }
        rates.received(frame, now);
        missions.received(frame, now, errands.transferring());
    }

    void advance(long now) {
        telemetry.advance(now);
        errands.advance(now);
        gimbal.advance(now);
    }

    /** Keeps a vehicle company that is known: it hears a ground station as long as the lane lives. */
    void sendHeartbeat(long now) {
        if (now - lastHeartbeatNanos >= HEARTBEAT_NANOS) {
            lastHeartbeatNanos = now;
            links.send(OWN_HEARTBEAT);
        }
    }

    /** Asks a vehicle that is heard for what it does not tell by itself. */
    void ask(long now) {
        links.ask(now);
        rates.advance(now);
        missions.advance(now, errands.transferring());
    }

    /** A drone listens from now on that knows nothing of the vehicle yet. */
    void begin(long now) {
        known = true;
        telemetry.identified();
        missions.begin(now);
    }

    /** The drone listens no more: ends all commands without knowing what becomes of them. */
    void abandon(String why) {
        known = false;
        errands.abandon(why);
    }

    boolean isIdle() {
        return errands.isEmpty();
    }

    /** All that goes out for it goes by its mandate. */
    void perform(SendAuthority mandate, Command command, VehicleChannel.Report report) {
        CommandId id = Objects.requireNonNull(mandate.command());
        long now = nanoTime.getAsLong();
        ReportingObserver observer = new ReportingObserver(report);
        MavlinkTarget fenced = target.through(message -> links.send(message, mandate));
        CommandContext cockpit = new CommandContext(
                status, parameters, fenced, observer, this::publish, missions::changedByCloud, telemetry::remark);
        errands.begin(id, command, autopilot.exchangeFor(command, cockpit), report, now);
    }

    /** Says it once, now, as far as this autopilot knows a word for it. */
    void steer(SendAuthority mandate, Setpoint setpoint) {
        autopilot.steer(setpoint, target).ifPresent(message -> links.send(message, mandate));
        gimbal.steered(mandate, setpoint, nanoTime.getAsLong());
    }

    void cancel(CommandId id, long now) {
        errands.cancel(id, now);
    }

    /** Asks for a sign of life. */
    void probe() {
        target.send(new CommandLong(
                target.systemId(), target.componentId(), REQUEST_MESSAGE, 0, Heartbeat.ID, 0f, 0f, 0f, 0f, 0f, 0f));
    }

    private void publish(DroneEvent event) {
        if (event instanceof DroneEvent.TextReported text) {
            errands.textReceived(text.severity(), text.text(), nanoTime.getAsLong());
        }
        news.accept(event);
    }
}
