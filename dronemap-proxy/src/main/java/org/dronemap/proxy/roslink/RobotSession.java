package org.dronemap.proxy.roslink;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.process.PeerPattern;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.dronemap.proxy.roslink.wire.RoslinkPacket;
import org.jspecify.annotations.Nullable;

/**
 * The server's session with one ROSLink robot over all its links: reports its state and carries out commands. Belongs
 * to the drone's lane; what says so may be called from anywhere.
 */
final class RobotSession implements VehicleChannel, Lane.TimedTask {
    private static final long GIVEN_UP_NANOS = 120_000_000_000L;
    private static final DroneEvent DRIVES_ON = new DroneEvent.TextReported(
            Severity.ALERT, "It was told to stand still five seconds ago and reports that it moves. Stop it by hand.");

    private final RobotSessionRegistry table;
    private final RobotIdentity name;
    private final String mark;
    private final RobotRecordingTap tape;
    private final RobotLinks links;
    private final RobotTelemetryTranslator telemetry;
    private final Map<CommandId, RobotCommandExchange> errands = new LinkedHashMap<>();
    private final ZeroVelocitySender standstill;
    private final CloudHeartbeatSender heartbeat;
    private volatile @Nullable DroneLink drone;
    private volatile boolean over;
    private @Nullable LinkReport publishedReport;

    RobotSession(RobotSessionRegistry table, RobotLink first, RobotType type) {
        this.table = table;
        this.name = first.name();
        DroneKey key = first.key();
        mark = new PeerPattern(key.address(), key.port(), key.systemId()).text();
        tape = table.tape();
        links = new RobotLinks(first);
        standstill = new ZeroVelocitySender(
                type.words().flies(),
                order -> links.best().send(order, SendAuthority.HOUSEKEEPING),
                () -> publish(DRIVES_ON));
        // On each link: a fail-safe of the robot's own may look at either.
        heartbeat = new CloudHeartbeatSender(
                order -> links.all().forEach(link -> link.send(order, SendAuthority.HOUSEKEEPING)));
        telemetry = new RobotTelemetryTranslator(
                type, name.hardware(), this::publish, () -> table.refusals().unreadable());
    }

    /** Any thread. */
    RobotLinks links() {
        return links;
    }

    /** Any thread. */
    RobotRecordingTap tape() {
        return tape;
    }

    RobotIdentity name() {
        return name;
    }

    /** Any thread. */
    Identification identification() {
        return telemetry.identification();
    }

    /** Any thread; null as long as it is bound to none. */
    @Nullable
    DroneId drone() {
        DroneLink bound = drone;
        return bound == null ? null : bound.id();
    }

    /** A new heartbeat makes a new session. Any thread. */
    boolean isOver() {
        return over;
    }

    /** It speaks for that drone. On the registry lane, once. */
    void bind(DroneLink bound) {
        drone = bound;
        tape.bound(bound.id());
        Lane lane = bound.lane();
        lane.execute(() -> {
            lane.addTimedTask(this);
            telemetry.identified();
            standstill.calledIn(table.now());
        });
    }

    /** Takes a message in; false when there was no room. Any thread. */
    boolean offer(RoslinkPacket packet) {
        DroneLink bound = drone;
        return bound != null && bound.lane().offer(() -> table.atWork().at(mark, () -> process(bound, packet)));
    }

    private void process(DroneLink bound, RoslinkPacket packet) {
        if (over || isGone(bound)) {
            return;
        }
        bound.received();
        telemetry.received(packet.message());
        RobotMessage message = packet.message();
        long now = table.now();
        standstill.received(message, telemetry.facts());
        List.copyOf(errands.values()).forEach(errand -> errand.received(message, telemetry.facts(), now));
        errands.values().removeIf(RobotCommandExchange::isOver);
    }

    /** Its drone was removed, or answers to another session. */
    private boolean isGone(DroneLink bound) {
        if (bound.isGone()) {
            end("Another link now speaks for the robot; look at the drone.");
            return true;
        }
        return false;
    }

    private void publish(DroneEvent event) {
        DroneLink bound = drone;
        if (bound != null) {
            bound.accept(event);
        }
    }

    @Override
    public void advance() {
        DroneLink bound = Objects.requireNonNull(drone);
        if (over || isGone(bound)) {
            return;
        }
        long now = table.now();
        // A robot that drives on hears first that it shall stand.
        standstill.advance(now);
        heartbeat.sendDue(now);
        List.copyOf(errands.values()).forEach(errand -> errand.advance(telemetry.facts(), now));
        errands.values().removeIf(RobotCommandExchange::isOver);
        tape.working(isWorking());
        links.measure(now);
        LinkReport report = links.report();
        if (!report.equals(publishedReport)) {
            publishedReport = report;
            bound.linkChanged(report);
        }
        if (links.silenceNanos() > GIVEN_UP_NANOS && errands.isEmpty()) {
            end("The robot has fallen silent.");
        }
    }

    private boolean isWorking() {
        RobotStatus facts = telemetry.facts();
        boolean moves = facts.speed() != null && !RobotGoal.Stopped.isStill(facts);
        return !errands.isEmpty() || Boolean.TRUE.equals(facts.armed()) || moves;
    }

    /** Its key is void: nothing goes to it from now on, and nothing that it says is heard. Any thread. */
    void expel() {
        links.cut();
        DroneLink bound = Objects.requireNonNull(drone);
        bound.lane().execute(() -> {
            if (!over) {
                end("The key of the robot was revoked.");
            }
        });
    }

    private void end(String why) {
        over = true;
        errands.values().forEach(errand -> errand.abandon(why));
        errands.clear();
        Objects.requireNonNull(drone).lane().removeTimedTask(this);
        tape.ended();
        table.ended(this);
    }

    @Override
    public void perform(SendAuthority mandate, Command command, Report report) {
        if (over) {
            report.ended(new Outcome.Refused(
                    "cloud", new Refusal(OutcomeCode.LINK_MISSING, "The robot has no link to the cloud.")));
            return;
        }
        Optional<RobotGoal> aim = RobotGoal.of(command);
        if (aim.isEmpty()) {
            report.ended(new Outcome.Refused(
                    "vehicle",
                    new Refusal(
                            OutcomeCode.CAPABILITY_MISSING,
                            "These robots cannot be told to " + command.summary() + ".")));
            return;
        }
        tape.working(true);
        standstill.commanded(aim.get() instanceof RobotGoal.Stopped, table.now());
        CommandId id = Objects.requireNonNull(mandate.command());
        errands.put(
                id,
                new RobotCommandExchange(
                        aim.get(), telemetry.facts(), order -> links.best().send(order, mandate), report, table.now()));
    }

    @Override
    public void steer(SendAuthority mandate, Setpoint setpoint) {
        if (over) {
            return;
        }
        switch (setpoint.kind()) {
            case VELOCITY -> steer(mandate, (Setpoint.Velocity) setpoint);
            case STICKS, TRACK -> {}
        }
    }

    private void steer(SendAuthority mandate, Setpoint.Velocity velocity) {
        if (!velocity.isStill()) {
            tape.working(true);
        }
        links.best().send(twist(velocity), mandate);
        if (velocity.isStill()) {
            standstill.stopSent(table.now());
        } else {
            standstill.moved();
        }
    }

    /**
     * Robots count to their left, upwards and in radians to the left, always as they stand themselves: the gate lets nobody
     * count from north, since nobody knows where they look.
     */
    private static RobotOrder twist(Setpoint.Velocity velocity) {
        if (velocity.isStill()) {
            return RobotOrder.Twist.STOP;
        }
        double left = velocity.facing() instanceof Setpoint.Facing.Turning turning
                ? 0.0 - Math.toRadians(turning.degreesPerSecond())
                : 0;
        return new RobotOrder.Twist(velocity.forward(), 0.0 - velocity.right(), 0.0 - velocity.down(), 0, 0, left);
    }

    @Override
    public void cancel(CommandId id) {
        errands.remove(id);
    }

    @Override
    public void probe() {
        // Robots answer no question; they speak once a second by themselves.
    }
}
