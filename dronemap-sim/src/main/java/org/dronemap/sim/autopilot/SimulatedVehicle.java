package org.dronemap.sim.autopilot;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.function.Consumer;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.mavlink.message.Timesync;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;

/**
 * A simulated MAVLink vehicle on one link: frames in, frames out, on a clock of its own. Owned by the fleet's thread;
 * knows nothing of sockets.
 */
public final class SimulatedVehicle {
    private static final int COMPONENT = 1;
    private static final int STEP_MILLIS = 50;
    private static final long BEAT_MILLIS = 1_000;
    private static final long REBOOT_MILLIS = 1_000;

    private SimulatedVehicleSettings settings;
    private final AutopilotKind kind;
    private final SimulatedCraft craft;
    private FrameWriter writer;
    private final Consumer<byte[]> link;
    private final SimulatedSigning signing;
    private final LinkCompanions companions;
    private TextSender texts = new TextSender(this::send);
    private int cells;
    private SimulatedAutopilot autopilot;
    private SimulatedMessageHandler desk;
    private long now;
    private long bootedAt;
    private long nextBeat;
    private long silentUntil = Long.MIN_VALUE;
    private boolean deaf;
    private boolean bannerDue;
    private boolean newAddressDue;

    public SimulatedVehicle(
            SimulatedVehicleSettings settings, AutopilotKind kind, SimulatedCraft craft, Consumer<byte[]> link) {
        this.settings = settings;
        this.kind = kind;
        this.craft = craft;
        this.link = link;
        this.writer = new FrameWriter(settings.systemId(), COMPONENT, settings.mavlinkVersion());
        this.signing =
                new SimulatedSigning(settings.usb(), () -> Instant.ofEpochMilli(settings.epochMicros() / 1000 + now));
        this.companions = new LinkCompanions(settings.systemId(), settings.mavlinkVersion(), link);
        this.nextBeat = settings.systemId() * 37L % BEAT_MILLIS;
        this.autopilot = makeAutopilot();
        this.desk = new SimulatedMessageHandler(autopilot, settings, 0, this::send, this::handle);
        this.bannerDue = true;
    }

    private SimulatedAutopilot makeAutopilot() {
        SimulatedAutopilot made =
                kind.maker().make(craft, settings.systemId(), this::handle, this::send, this::sendHeartbeat);
        made.stick(settings.stick());
        settings.presets().forEach((name, value) -> {
            if (!made.parameters().set(name, value)) {
                throw new IllegalArgumentException("this autopilot has no parameter '" + name + "'");
            }
        });
        ParameterPadding.pad(made.parameters(), settings.parameters(), made.parametersAsBits());
        return made;
    }

    /** Lives on to that time, in steps that the physics can take. */
    public void advance(long untilMillis) {
        while (now < untilMillis) {
            long step = Math.min(STEP_MILLIS, untilMillis - now);
            now += step;
            autopilot.step(now, step / 1000.0);
            sendTelemetry();
        }
    }

    private void sendTelemetry() {
        if (isSilent()) {
            return;
        }
        if (bannerDue && !kind.banner().isEmpty()) {
            link.accept(kind.banner().getBytes(StandardCharsets.US_ASCII));
        }
        bannerDue = false;
        if (now >= nextBeat) {
            // Beats that were missed while it could not speak are not made up for.
            nextBeat += BEAT_MILLIS * ((now - nextBeat) / BEAT_MILLIS + 1);
            sendHeartbeat();
            send(new Timesync(0, now * 1_000_000, 0, 0));
        }
        companions.step(now);
        desk.step(now);
    }

    private void sendHeartbeat() {
        send(autopilot.heartbeat());
    }

    private void send(Message message) {
        if (!isSilent()) {
            link.accept(signing.frame(writer, message));
        }
    }

    private void handle(FlightEvent event) {
        if (event instanceof FlightEvent.Text text) {
            texts.send(text.severity(), text.text());
        } else if (event instanceof FlightEvent.Ordered ordered) {
            execute(ordered.order());
        } else if (event instanceof FlightEvent.ItemReached reached) {
            desk.reached(reached.index());
        } else if (event instanceof FlightEvent.ItemStarted started) {
            desk.started(started);
        }
    }

    private void execute(SimulatedMissionItem order) {
        boolean onePicture = (order.command() == SimulatedMissionItem.DIGICAM_CONTROL && order.x() == 1)
                || (order.command() == MavCmd.IMAGE_START_CAPTURE && order.param3() == 1);
        if (onePicture) {
            send(autopilot.takePicture());
        } else if (order.command() == SimulatedMissionItem.SET_SERVO
                && !autopilot.payload().setServo((int) order.param1(), (int) order.param2())) {
            sendText(TextSeverity.INFO, "ServoRelayEvent: Channel " + (int) order.param1() + " is already in use");
        }
    }

    public void receive(Frame frame) {
        if (deaf || isSilent() || !signing.accepts(frame)) {
            return;
        }
        if (frame.messageId() == SetupSigning.ID) {
            setUpSigning(SetupSigning.decode(frame));
            return;
        }
        if (frame.messageId() == Heartbeat.ID) {
            autopilot.heartbeatReceived(frame.systemId());
            return;
        }
        if (desk.receive(frame, now)) {
            reboot();
        }
    }

    private void setUpSigning(SetupSigning setup) {
        if (setup.targetSystem() != settings.systemId()) {
            return;
        }
        if (craft.armed() && !autopilot.acceptsKeysWhenArmed()) {
            sendText(TextSeverity.WARNING, "ERROR: Won't setup signing when armed");
            return;
        }
        signing.setUp(setup);
    }

    /** Switches off and on again: parameters, mission and battery stay, everything else is found anew. */
    public void reboot() {
        SimulatedParameters kept = autopilot.parameters();
        var fence = autopilot.fence().items();
        var rallyPoints = autopilot.rallyPoints().items();
        applySystemId(kept);
        texts = new TextSender(this::send);
        var items = autopilot.plan().items();
        craft.setArmed(false);
        craft.repair();
        craft.navigation().restart();
        bootedAt = now;
        autopilot = makeAutopilot();
        for (int i = 0; i < kept.size(); i++) {
            autopilot.parameters().set(kept.at(i).name(), kept.at(i).value());
        }
        autopilot.plan().replaceAll(items);
        autopilot.rallyPoints().store(rallyPoints);
        // From here on nothing is heard of it until it is up again.
        silentUntil = now + REBOOT_MILLIS;
        autopilot.fence().store(fence);
        autopilot.step(now, 0.001);
        desk = new SimulatedMessageHandler(autopilot, settings, bootedAt, this::send, this::handle);
        desk.batteries().setCells(cells);
        nextBeat = now + REBOOT_MILLIS;
        bannerDue = true;
        newAddressDue = true;
    }

    /** A system id that was written counts from the next start. */
    private void applySystemId(SimulatedParameters kept) {
        for (String name : new String[] {"SYSID_THISMAV", "MAV_SYS_ID"}) {
            SimulatedParameters.Parameter written = kept.find(name);
            if (written != null && written.value() >= 1 && written.value() <= 255) {
                settings = settings.withSystemId((int) written.value());
                writer = new FrameWriter(settings.systemId(), COMPONENT, settings.mavlinkVersion());
            }
        }
    }

    /** True once after a reboot: a new socket has a new port. */
    public boolean changeAddress() {
        boolean due = newAddressDue && !isSilent();
        newAddressDue &= !due;
        return due;
    }

    private boolean isSilent() {
        return now < silentUntil;
    }

    public void silence(long millis) {
        silentUntil = now + millis;
    }

    /** Hears no more of what the ground says, though it goes on talking. */
    public void setDeaf(boolean on) {
        deaf = on;
    }

    public void sendText(TextSeverity severity, String text) {
        handle(new FlightEvent.Text(severity, text));
    }

    /** Who else speaks on its link. */
    public LinkCompanions companions() {
        return companions;
    }

    /** So many cells of its battery are told one by one; 0: their sum alone. */
    public void setCells(int count) {
        cells = count;
        desk.batteries().setCells(count);
    }

    /** Its battery's monitor stops measuring, and says so. */
    public void setBatteryUnknown(boolean on) {
        desk.batteries().setUnknown(on);
    }

    /** What it keeps otherwise than it was told; a reboot forgets it. */
    public SimulatedStorageFaults alterations() {
        return desk.alterations();
    }

    public SimulatedAutopilot autopilot() {
        return autopilot;
    }

    public SimulatedSigning signing() {
        return signing;
    }

    public SimulatedCraft craft() {
        return craft;
    }

    public int systemId() {
        return settings.systemId();
    }

    public String kindName() {
        return kind.name();
    }

    public long nowMillis() {
        return now;
    }
}
