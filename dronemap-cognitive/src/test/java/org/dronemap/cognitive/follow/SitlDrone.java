package org.dronemap.cognitive.follow;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/**
 * A real ArduCopter in software in the air. The trial goes by its clock, so that a slow machine makes nothing late but what is
 * said to it; the truth is that of its physics. Owned by one thread.
 */
final class SitlDrone implements TestCopter, AutoCloseable {
    private static final int SIMSTATE = 164;
    private static final int REPORT_MICROS = 20_000;
    private static final int TAKE_OFF = 22;
    private static final int SET_MODE = 176;
    private static final int ARM = 400;
    private static final int INTERVAL = 511;
    private static final int REQUEST = 512;
    private static final int GUIDED = 4;
    private static final int ARMED = 0x80;
    private static final int SILENT_MILLIS = 10_000;
    private static final long SECOND = 1_000_000_000L;
    private static final long READY_SECONDS = 300;
    private static final long SETTLE_SECONDS = 5;

    private final LocalFrame frame =
            new LocalFrame(SimDrone.HOME.latitudeDegrees(), SimDrone.HOME.longitudeDegrees(), SimDrone.HOME_AMSL);
    private final FrameReader fromVehicle = new FrameReader();
    private final FrameWriter ground = new FrameWriter(255, 190, 2);
    private final Map<Integer, Integer> answers = new HashMap<>();
    private final DatagramPacket packet = new DatagramPacket(new byte[2_048], 2_048);
    private final DatagramSocket socket;
    private final SitlProcess process;
    private @Nullable SocketAddress vehicle;
    private @Nullable GlobalPositionInt estimate;
    private @Nullable AutopilotVersion version;
    private @Nullable NeuPosition truth;
    private boolean guided;
    private long truthMillis;
    private long nowMillis;
    private long beatNanos;

    /** In the air over its home at that height, in a wind of so many m/s; it takes a minute until then. */
    SitlDrone(Path binary, double lean, double meters, double wind, long seed) {
        try {
            socket = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            socket.setSoTimeout(SILENT_MILLIS);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        process = new SitlProcess(binary, socket.getLocalPort(), lean, wind, seed);
        try {
            rise(meters);
        } catch (RuntimeException e) {
            close();
            throw e;
        }
    }

    private void rise(double meters) {
        // What it grants while it starts it forgets.
        asked("is armed in GUIDED", () -> guided, command(SET_MODE, 1, GUIDED), command(ARM, 1, 0));
        granted("takes off", new CommandLong(1, 1, TAKE_OFF, 0, 0, 0, 0, 0, 0, 0, (float) meters));
        asked("reports its place", () -> estimate != null, command(INTERVAL, GlobalPositionInt.ID, REPORT_MICROS));
        asked("tells the truth", () -> truth != null, command(INTERVAL, SIMSTATE, REPORT_MICROS));
        asked("says what it is", () -> version != null, command(REQUEST, AutopilotVersion.ID, 0));
        await("is at its height", () -> position().up() > meters - 1);
        long settled = System.nanoTime() + SETTLE_SECONDS * SECOND;
        await("stands", () -> System.nanoTime() > settled);
        nowMillis = known(estimate).timeBootMs();
    }

    private static CommandLong command(int number, float first, float second) {
        return new CommandLong(1, 1, number, 0, first, second, 0, 0, 0, 0, 0);
    }

    private void granted(String what, CommandLong command) {
        answers.remove(command.command());
        asked(what, () -> answers.getOrDefault(command.command(), -1) == 0, command);
    }

    /** Asks each second: an autopilot that has just started refuses for a while. */
    private void asked(String what, BooleanSupplier condition, CommandLong... commands) {
        long[] last = {System.nanoTime() - SECOND};
        await(what, () -> {
            if (vehicle != null && System.nanoTime() - last[0] >= SECOND) {
                last[0] = System.nanoTime();
                for (CommandLong command : commands) {
                    send(command);
                }
            }
            return condition.getAsBoolean();
        });
    }

    private void await(String what, BooleanSupplier condition) {
        long deadline = System.nanoTime() + READY_SECONDS * SECOND;
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > deadline) {
                throw new IllegalStateException(
                        "not within " + READY_SECONDS + " s: ArduCopter " + what + "; " + estimate + ", " + truth);
            }
            listen();
        }
    }

    /** As its heartbeats and reports come; whoever waits sees time go by. */
    private void listen() {
        try {
            packet.setLength(packet.getData().length);
            socket.receive(packet);
        } catch (SocketTimeoutException e) {
            throw new IllegalStateException("ArduCopter is silent", e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        vehicle = packet.getSocketAddress();
        fromVehicle.readDatagram(ByteBuffer.wrap(packet.getData(), 0, packet.getLength()), this::heard);
        if (System.nanoTime() - beatNanos > SECOND) {
            beatNanos = System.nanoTime();
            send(new Heartbeat(6, 8, 0, 0, 4, 3));
        }
    }

    private void heard(Frame said) {
        switch (said.messageId()) {
            case GlobalPositionInt.ID -> estimate = GlobalPositionInt.decode(said);
            case Heartbeat.ID -> {
                Heartbeat beat = Heartbeat.decode(said);
                guided = (beat.baseMode() & ARMED) != 0 && beat.customMode() == GUIDED;
            }
            case AutopilotVersion.ID -> version = AutopilotVersion.decode(said);
            case CommandAck.ID -> {
                CommandAck answer = CommandAck.decode(said);
                answers.put(answer.command(), answer.result());
            }
            case SIMSTATE -> {
                GlobalPositionInt near = estimate;
                if (near != null) {
                    // It has no time of its own, and no height.
                    truthMillis = near.timeBootMs();
                    truth = frame.locate(said.i32(36) / 1e7, said.i32(40) / 1e7, near.relativeAlt() / 1e3);
                }
            }
            default -> {}
        }
    }

    private void send(Message message) {
        byte[] bytes = ground.frame(message);
        try {
            socket.send(new DatagramPacket(bytes, bytes.length, known(vehicle)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static <T> T known(@Nullable T what) {
        return Objects.requireNonNull(what, "ArduCopter has not said it");
    }

    /** "ArduCopter 4.5.6". */
    String name() {
        long number = known(version).flightSwVersion();
        return "ArduCopter " + (number >> 24) + "." + (number >> 16 & 0xFF) + "." + (number >> 8 & 0xFF);
    }

    @Override
    public void live(double seconds) {
        nowMillis += Math.round(seconds * 1_000);
        while (known(estimate).timeBootMs() < nowMillis) {
            listen();
        }
    }

    @Override
    public void hear(GuidanceSetpoint aim) {
        send(SetpointMessages.moving(aim));
    }

    @Override
    public void hearPlace(GuidanceSetpoint aim) {
        send(SetpointMessages.place(aim));
    }

    /** Now by the trial's clock: a few milliseconds beside the report. */
    @Override
    public NeuPosition position() {
        NeuPosition here = truth;
        if (here == null) {
            return new NeuPosition(0, 0, 0);
        }
        GlobalPositionInt moving = known(estimate);
        double late = nowMillis == 0 ? 0 : (nowMillis - truthMillis) / 1e3;
        return new NeuPosition(
                here.north() + moving.vx() / 1e2 * late, here.east() + moving.vy() / 1e2 * late, here.up());
    }

    @Override
    public DroneFix whereabouts(Instant at) {
        GlobalPositionInt said = known(estimate);
        return new DroneFix(
                at,
                new Geodetic(said.lat() / 1e7, said.lon() / 1e7),
                said.alt() / 1e3,
                said.vy() / 1e2,
                said.vx() / 1e2);
    }

    @Override
    public Geodetic place(double east, double north) {
        NeuPosition there = new NeuPosition(north, east, 0);
        return new Geodetic(frame.latitudeOf(there), frame.longitudeOf(there));
    }

    @Override
    public void close() {
        process.close();
        socket.close();
    }
}
