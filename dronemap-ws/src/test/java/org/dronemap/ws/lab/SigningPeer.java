package org.dronemap.ws.lab;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.time.Worker;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SetupSigning;

/**
 * A vehicle that does what a test tells it to, rightly or not: it beats each half second, arms, disarms and changes its mode,
 * refuses the rest, and keeps what came to it.
 */
public final class SigningPeer {
    public static final int ARM = 400;

    private static final int SET_MODE = 176;
    private static final int REQUEST_MESSAGE = 512;
    /** Who are you. */
    private static final Set<Integer> QUESTIONS = Set.of(REQUEST_MESSAGE, 520);

    private static final int UNSUPPORTED = 3;
    private static final int QUADROTOR = 2;
    private static final int ARDUPILOT = 3;
    private static final int STANDBY = 3;
    private static final int CUSTOM_MODE = 1;
    private static final int ARMED = 128;
    private static final long FIRMWARE = 0x040506FFL;
    private static final Duration BEAT = Duration.ofMillis(500);
    private static final int MOST_UNDER_WAY = 10_000;

    private final Laboratory lab;
    private final int systemId;
    private final LabVehicleLink wire;
    private final FrameWriter writer;
    private final Worker worker;
    private final PeerSigning signing;
    private final List<Frame> received = new ArrayList<>();
    private final Map<Integer, Consumer<Frame>> answers = new HashMap<>();
    private final List<byte[]> heldBack = new ArrayList<>();
    private Duration slow = Duration.ZERO;
    private long slowUntilNanos;
    private long hardware;
    private boolean armed;
    private boolean silent;
    private long mode;
    private long sent;
    private int losesEvery;
    private byte[] last = {};

    SigningPeer(Laboratory lab, int systemId, Function<Consumer<Frame>, LabVehicleLink> wires) {
        this.lab = lab;
        this.systemId = systemId;
        this.wire = wires.apply(this::hear);
        this.writer = new FrameWriter(systemId, 1, 2);
        this.worker = lab.time().worker("peer", MOST_UNDER_WAY);
        this.signing = new PeerSigning(lab.time().clock());
    }

    /** Says so when it is asked which board it is. */
    public SigningPeer withHardware(long uid) {
        hardware = uid;
        return this;
    }

    /** Beats from now on. */
    public SigningPeer begin() {
        var unused = worker.every(Duration.ZERO, BEAT, this::beat);
        return this;
    }

    /** Does that with such messages from now on, and nothing else. */
    public SigningPeer answers(int messageId, Consumer<Frame> how) {
        answers.put(messageId, how);
        return this;
    }

    /** Does that again and again. */
    public void goesOn(Duration pause, Runnable what) {
        var unused = worker.every(pause, pause, what);
    }

    /** Does that a little later. */
    public void later(Duration pause, Runnable what) {
        var unused = worker.after(pause, what);
    }

    public void beat() {
        say(new Heartbeat(QUADROTOR, ARDUPILOT, CUSTOM_MODE | (armed ? ARMED : 0), mode, STANDBY, 3));
    }

    /** That it is there, in degrees times ten million, ten metres up. */
    public void isAt(int latitude, int longitude) {
        say(new GlobalPositionInt(0, latitude, longitude, 498_000, 10_000, 0, 0, 0, 0));
    }

    /** Says which board it is though nobody asked. */
    public void namesItsHardware() {
        int[] none = new int[8];
        say(new AutopilotVersion(0, FIRMWARE, 0, 0, 0, none, none, none, 0, 0, hardware, new int[18]));
    }

    public void say(Message message) {
        if (silent) {
            return;
        }
        sent++;
        last = signing.frame(writer, message);
        if (losesEvery > 0 && sent % losesEvery == 0) {
            return;
        }
        if (lab.time().nanos() < slowUntilNanos) {
            heldBack.add(last);
        } else {
            wire.up(last);
        }
    }

    /** Bytes as they are, not counted. */
    public void sayRaw(byte[] bytes) {
        wire.up(bytes);
    }

    /** Whenever it gets a key, what it says in the next moment arrives at its end only. */
    public void isSlowAfterKeys(Duration moment) {
        slow = moment;
    }

    /** Each message of that count gets lost after it was numbered, as on a bad link; 0: none. */
    public void losesEvery(int count) {
        losesEvery = count;
    }

    private void slowDown() {
        if (!slow.isZero()) {
            slowUntilNanos = lab.time().nanos() + slow.toNanos();
            later(slow, () -> {
                heldBack.forEach(wire::up);
                heldBack.clear();
            });
        }
    }

    private void hear(Frame frame) {
        if (!signing.accepts(frame)) {
            return;
        }
        received.add(frame);
        Consumer<Frame> answer = answers.get(frame.messageId());
        if (answer != null) {
            answer.accept(frame);
            return;
        }
        switch (frame.messageId()) {
            case CommandLong.ID -> {
                CommandLong command = CommandLong.decode(frame);
                obey(command.command(), command.param1(), command.param2());
            }
            case CommandInt.ID -> {
                CommandInt command = CommandInt.decode(frame);
                obey(command.command(), command.param1(), command.param2());
            }
            case SetMode.ID -> {
                mode = SetMode.decode(frame).customMode();
                beat();
            }
            case SetupSigning.ID -> {
                if (signing.take(SetupSigning.decode(frame))) {
                    slowDown();
                }
            }
            default -> {
                // kept, and not answered
            }
        }
    }

    private void obey(int command, float param1, float param2) {
        if (command == REQUEST_MESSAGE && param1 == AutopilotVersion.ID && hardware != 0) {
            namesItsHardware();
            return;
        }
        if (command == ARM) {
            armed = param1 == 1;
        } else if (command == SET_MODE) {
            mode = (long) param2;
        } else {
            say(new CommandAck(command, UNSUPPORTED, 0, 0, 0, 0));
            return;
        }
        say(new CommandAck(command, 0, 0, 0, 0, 0));
        beat();
    }

    public void setSilent(boolean on) {
        silent = on;
    }

    public void setArmed(boolean on) {
        armed = on;
    }

    public boolean isArmed() {
        return armed;
    }

    public int systemId() {
        return systemId;
    }

    public LabVehicleLink wire() {
        return wire;
    }

    public PeerSigning signing() {
        return signing;
    }

    /** Messages that it has said, those under way included. */
    public long sent() {
        return sent;
    }

    /** The last frame that it has said, as it went out. */
    public byte[] lastFrame() {
        return last.clone();
    }

    /** What came to it, oldest first. */
    public List<Frame> received() {
        return List.copyOf(received);
    }

    public List<Frame> received(int messageId) {
        return received.stream().filter(frame -> frame.messageId() == messageId).toList();
    }

    public void forgetReceived() {
        received.clear();
    }

    /** Whom the commands of that number that came to it were meant for. */
    public List<Integer> commanded(int number) {
        List<Integer> targets = new ArrayList<>();
        for (Frame frame : received) {
            if (command(frame) == number) {
                targets.add(
                        frame.messageId() == CommandLong.ID
                                ? CommandLong.decode(frame).targetSystem()
                                : CommandInt.decode(frame).targetSystem());
            }
        }
        return targets;
    }

    private static int command(Frame frame) {
        return switch (frame.messageId()) {
            case CommandLong.ID -> CommandLong.decode(frame).command();
            case CommandInt.ID -> CommandInt.decode(frame).command();
            default -> -1;
        };
    }

    /** What came to it beyond the question who it is. */
    public List<Frame> toldToAct() {
        return received.stream().filter(frame -> !isQuestion(frame)).toList();
    }

    /** It asks who somebody is, and nothing more. */
    public static boolean isQuestion(Frame frame) {
        return frame.messageId() == CommandLong.ID && QUESTIONS.contains(command(frame));
    }

    /** Frames of the server that are missing between those that came. */
    public int gaps() {
        int missing = 0;
        for (int i = 1; i < received.size(); i++) {
            missing += (received.get(i).sequence() - received.get(i - 1).sequence() - 1) & 0xFF;
        }
        return missing;
    }

    /** The drone that is heard at its address. */
    public Optional<DroneState> known() {
        return lab.server().house().cloud().drones().stream()
                .filter(state -> state.link().key().systemId() == systemId
                        && state.link().key().port() == wire.port())
                .findFirst();
    }

    /** Waits until the server knows it. */
    public DroneId listed() {
        return lab.until(
                        "the peer " + systemId + " is listed",
                        Duration.ofSeconds(20),
                        () -> known().filter(state -> state.link().state() == LinkState.LIVE))
                .id();
    }
}
