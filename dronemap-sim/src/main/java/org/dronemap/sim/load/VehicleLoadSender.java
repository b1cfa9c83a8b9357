package org.dronemap.sim.load;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.List;

/** Load test: sends the frames of all vehicles at a fixed rate, each from a port of its own. One thread. */
final class VehicleLoadSender {
    private static final int FAREWELLS = 3;

    private final int vehicles;
    private final int perSecond;
    private final int steps;
    private final List<LoadFrames> frames = new ArrayList<>();
    private final List<DatagramChannel> channels = new ArrayList<>();
    private final LatencyPercentiles lateness = new LatencyPercentiles();
    private long sent;
    private long refused;

    VehicleLoadSender(LoadArguments arguments) throws IOException {
        vehicles = arguments.integer("--vehicles");
        perSecond = arguments.integer("--rate");
        steps = arguments.integer("--steps");
        int hosts = Math.toIntExact((long) arguments.number("--hosts", 1));
        boolean onlyPositions = arguments.text("--only-positions", "no").equals("yes");
        InetSocketAddress server = new InetSocketAddress(InetAddress.getLoopbackAddress(), arguments.integer("--port"));
        for (int vehicle = 0; vehicle < vehicles; vehicle++) {
            frames.add(new LoadFrames(vehicle, perSecond, onlyPositions));
            DatagramChannel channel = DatagramChannel.open();
            channel.bind(new InetSocketAddress(host(vehicle % hosts), 0));
            channel.connect(server);
            channel.configureBlocking(false);
            channels.add(channel);
        }
    }

    /** Whole 127.0.0.0/8 is this machine: vehicles may be spread over some of its addresses. */
    private static InetAddress host(int number) throws IOException {
        return InetAddress.getByAddress(new byte[] {127, 0, 0, (byte) (number + 1)});
    }

    /** Says that it is ready, and sends from the time that it is then told: a slow start must not become a burst. */
    String run(BufferedReader told, PrintStream out) throws IOException {
        out.println("ready");
        String startNanos = told.readLine();
        if (startNanos == null) {
            throw new IllegalArgumentException("nobody said when to start");
        }
        return run(new SendSchedule(Long.parseLong(startNanos.strip()), vehicles, perSecond));
    }

    String run(SendSchedule pace) throws IOException {
        for (int step = 0; step < steps; step++) {
            for (int vehicle = 0; vehicle < vehicles; vehicle++) {
                long due = pace.dueNanos(vehicle, step);
                SendSchedule.await(due);
                send(vehicle, frames.get(vehicle).next());
                lateness.add(System.nanoTime() - due);
            }
        }
        for (int again = 0; again < FAREWELLS; again++) {
            for (int vehicle = 0; vehicle < vehicles; vehicle++) {
                send(vehicle, frames.get(vehicle).disarmed());
            }
        }
        for (DatagramChannel channel : channels) {
            channel.close();
        }
        return "{\"sent\":" + sent + ",\"refused\":" + refused + ",\"lateness\":" + lateness.json() + "}";
    }

    private void send(int vehicle, byte[] frame) throws IOException {
        if (channels.get(vehicle).write(ByteBuffer.wrap(frame)) == frame.length) {
            sent++;
        } else {
            refused++;
        }
    }
}
