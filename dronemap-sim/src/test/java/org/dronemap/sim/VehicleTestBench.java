package org.dronemap.sim;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.sim.autopilot.SimulatedVehicle;

/** A vehicle on a bench: real frames to and from it, no socket, a clock that the test turns. */
final class VehicleTestBench {
    record Heard(long millis, Frame frame) {}

    final SimulatedVehicle vehicle;
    final List<Heard> heard = new ArrayList<>();
    private final FrameReader fromVehicle = new FrameReader();
    private final FrameReader toVehicle = new FrameReader();
    private final FrameWriter ground = new FrameWriter(255, 190, 2);
    private long now;
    private boolean groundTalks = true;

    VehicleTestBench(String... options) {
        SimulatorOptions parsed = SimulatorOptions.parse(List.of(options));
        this.vehicle = new SimulatedFleetBuilder(parsed, 0).vehicle(0, this::take);
    }

    static VehicleTestBench ready(String... options) {
        VehicleTestBench bench = new VehicleTestBench(options);
        bench.run(6);
        bench.heard.clear();
        return bench;
    }

    /** ArduCopter in GUIDED at that height. */
    static VehicleTestBench flying(double meters, String... options) {
        VehicleTestBench bench = ready(options);
        bench.command(176, 1, 4);
        bench.command(400, 1);
        bench.command(22, 0, 0, 0, 0, 0, 0, (float) meters);
        bench.run(25);
        bench.heard.clear();
        return bench;
    }

    private void take(byte[] bytes) {
        fromVehicle.read(ByteBuffer.wrap(bytes), frame -> heard.add(new Heard(now, frame)));
    }

    void groundTalks(boolean on) {
        groundTalks = on;
    }

    void run(double seconds) {
        runTo(now + Math.round(seconds * 1000));
    }

    void runTo(long millis) {
        while (now < millis) {
            if (groundTalks && now % 1000 < 20) {
                send(new Heartbeat(6, 8, 0, 0, 4, 3));
            }
            now += Math.min(20, millis - now);
            vehicle.advance(now);
        }
    }

    long now() {
        return now;
    }

    void send(Message message) {
        toVehicle.read(ByteBuffer.wrap(ground.frame(message)), vehicle::receive);
    }

    void send(Message message, FrameSigner signer) {
        toVehicle.read(ByteBuffer.wrap(ground.frame(message, signer)), vehicle::receive);
    }

    /** The result; -1 when none came. */
    int command(int command, float... p) {
        float[] all = new float[7];
        System.arraycopy(p, 0, all, 0, p.length);
        heard.removeIf(h -> h.frame().messageId() == CommandAck.ID);
        send(new CommandLong(1, 1, command, 0, all[0], all[1], all[2], all[3], all[4], all[5], all[6]));
        return heard.stream()
                .filter(h -> h.frame().messageId() == CommandAck.ID)
                .map(h -> CommandAck.decode(h.frame()))
                .filter(ack -> ack.command() == command)
                .mapToInt(CommandAck::result)
                .findFirst()
                .orElse(-1);
    }

    void parameter(String name, double value) {
        send(new ParamSet(1, 1, name, (float) value, 9));
    }

    List<String> texts() {
        return heard.stream()
                .filter(h -> h.frame().messageId() == Statustext.ID)
                .map(h -> Statustext.decode(h.frame()).text())
                .toList();
    }

    long count(int messageId) {
        return heard.stream().filter(h -> h.frame().messageId() == messageId).count();
    }

    /** The last message of that kind. */
    <T> T last(int messageId, Function<Frame, T> decoder) {
        return heard.stream()
                .filter(h -> h.frame().messageId() == messageId)
                .reduce((earlier, later) -> later)
                .map(h -> decoder.apply(h.frame()))
                .orElseThrow(() -> new AssertionError("no message " + messageId + " was heard"));
    }

    Heartbeat beat() {
        return vehicle.autopilot().heartbeat();
    }

    long mode() {
        return beat().customMode();
    }

    boolean armed() {
        return vehicle.craft().armed();
    }

    double height() {
        return vehicle.craft().aboveHome();
    }

    MissionItemInt item(int seq, int command, double north, double east, float up) {
        var position = new org.dronemap.sim.physics.NeuPosition(north, east, 0);
        var frame = vehicle.craft().home();
        boolean placed = command == 16;
        return new MissionItemInt(
                1,
                1,
                seq,
                3,
                command,
                0,
                1,
                0,
                0,
                0,
                0,
                placed ? (int) Math.round(frame.latitudeOf(position) * 1e7) : 0,
                placed ? (int) Math.round(frame.longitudeOf(position) * 1e7) : 0,
                up,
                0);
    }

    void upload(MissionItemInt... items) {
        send(new MissionCount(1, 1, items.length, 0));
        for (MissionItemInt item : items) {
            send(item);
        }
    }
}
