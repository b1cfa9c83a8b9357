package org.dronemap.ws.lab;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneState;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.Statustext;

/** A vehicle that does what the test tells it to, rightly or not; it says twice a second that it is there. */
public final class ScriptedPeer implements LabVehicle {
    public static final int ARM_DISARM = 400;
    public static final int ACCEPTED = 0;
    public static final int UNSUPPORTED = 3;
    public static final int FAILED = 4;

    private static final int DO_SET_MODE = 176;
    private static final int PX4 = 12;
    private static final int CUSTOM_MODE_ENABLED = 1;
    private static final int ARMED = 128;
    private static final int CRITICAL = 2;
    private static final int STANDBY = 3;
    private static final int ACTIVE = 4;
    private static final Duration BEAT = Duration.ofMillis(500);

    /**
     * What it says it is, in the numbers of MAVLink.
     *
     * @param version of MAVLink
     */
    public record Kind(int type, int autopilot, int component, int version) {
        public static final Kind COPTER = new Kind(2, 3, 1, 2);

        public static Kind vehicle(int type, int autopilot) {
            return new Kind(type, autopilot, 1, 2);
        }
    }

    /** What it answers; nothing of it by itself. */
    @FunctionalInterface
    public interface Answers {
        void to(ScriptedPeer peer, Frame frame);
    }

    /** Arms, disarms, changes its mode and refuses all else, as an autopilot on the ground would. */
    public static final Answers OBEDIENT = ScriptedPeer::obey;

    private final Laboratory lab;
    private final int port;
    private final Kind kind;
    private final Answers answers;
    private final LabVehicleLink wire;
    private final FrameWriter writer;
    private final List<Frame> received = new ArrayList<>();
    private boolean armed;
    private boolean silent;
    private long customMode;
    private int status = STANDBY;

    ScriptedPeer(Laboratory lab, int port, int systemId, Kind kind, Answers answers) {
        this.lab = lab;
        this.port = port;
        this.kind = kind;
        this.answers = answers;
        this.writer = new FrameWriter(systemId, kind.component(), kind.version());
        this.wire = lab.wire("peer at " + port, port, this::receive);
        var unused = lab.time().worker("peer at " + port, 1).every(BEAT, BEAT, this::beat);
    }

    private void receive(Frame frame) {
        received.add(frame);
        answers.to(this, frame);
    }

    private static void obey(ScriptedPeer peer, Frame frame) {
        if (frame.messageId() == SetMode.ID) {
            peer.isIn(SetMode.decode(frame).customMode());
        } else if (frame.messageId() == CommandInt.ID) {
            peer.acknowledges(CommandInt.decode(frame).command(), UNSUPPORTED);
        } else if (frame.messageId() == CommandLong.ID) {
            peer.obey(CommandLong.decode(frame));
        }
    }

    private void obey(CommandLong order) {
        if (order.command() == ARM_DISARM) {
            armed = order.param1() == 1;
        } else if (order.command() == DO_SET_MODE) {
            customMode = modeOf(order);
        } else {
            acknowledges(order.command(), UNSUPPORTED);
            return;
        }
        acknowledges(order.command(), ACCEPTED);
        beat();
    }

    /** PX4 has a main and a sub mode. */
    private long modeOf(CommandLong order) {
        return kind.autopilot() == PX4
                ? (long) order.param2() << 16 | (long) order.param3() << 24
                : (long) order.param2();
    }

    /** Says that it is there. */
    public void beat() {
        says(new Heartbeat(
                kind.type(), kind.autopilot(), CUSTOM_MODE_ENABLED | (armed ? ARMED : 0), customMode, status, 3));
    }

    public void says(Message message) {
        write(writer.frame(message));
    }

    public void says(String sentence) {
        says(new Statustext(CRITICAL, sentence, 0, 0));
    }

    public void acknowledges(int command, int result) {
        says(new CommandAck(command, result, 0, 0, 0, 0));
    }

    /** Bytes that need not be a frame. */
    public void write(byte[] bytes) {
        if (!silent) {
            wire.up(bytes);
        }
    }

    /** It says nothing, and hears all. */
    public void isSilent(boolean on) {
        silent = on;
    }

    /** Its mode, in its autopilot's own number; the server hears of it. */
    public void isIn(long mode) {
        customMode = mode;
        beat();
    }

    public void isArmed(boolean on) {
        armed = on;
    }

    /** It flies, as it says. */
    public void isInTheAir() {
        armed = true;
        status = ACTIVE;
        beat();
    }

    public boolean armed() {
        return armed;
    }

    public long customMode() {
        return customMode;
    }

    /** What came of that kind of order, in the form of most. */
    public List<CommandLong> orders(int command) {
        return received(CommandLong.ID)
                .map(CommandLong::decode)
                .filter(order -> order.command() == command)
                .toList();
    }

    private Stream<Frame> received(int messageId) {
        return received.stream().filter(frame -> frame.messageId() == messageId);
    }

    public int port() {
        return port;
    }

    @Override
    public LabVehicleLink wire() {
        return wire;
    }

    @Override
    public Optional<DroneState> known() {
        return lab.server().house().cloud().drones().stream()
                .filter(state -> state.link().key().port() == port)
                .findFirst();
    }

    @Override
    public String words() {
        return "peer at " + port + ": truly " + (armed ? "armed" : "disarmed") + " in mode " + customMode
                + "; for the server "
                + known().map(state -> state.mode() + ", armed " + state.armed())
                        .orElse("unknown");
    }
}
