package org.dronemap.sim.load;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.List;

/** Sends what all load vehicles say, each from a port of its own, at a pace that waits for nobody. One thread. */
final class Sender {
    private static final int FAREWELLS = 3;

    private final Pace pace;
    private final int steps;
    private final List<LoadFrames> frames = new ArrayList<>();
    private final List<DatagramChannel> channels = new ArrayList<>();
    private final Spread lateness = new Spread();
    private long sent;
    private long refused;

    Sender(Arguments arguments) throws IOException {
        pace = new Pace(
                arguments.longInteger("--start-nanos"), arguments.integer("--vehicles"), arguments.integer("--rate"));
        steps = arguments.integer("--steps");
        boolean onlyPositions = arguments.text("--only-positions", "no").equals("yes");
        InetSocketAddress server = new InetSocketAddress(InetAddress.getLoopbackAddress(), arguments.integer("--port"));
        for (int vehicle = 0; vehicle < pace.vehicles(); vehicle++) {
            frames.add(new LoadFrames(vehicle, pace.perSecond(), onlyPositions));
            DatagramChannel channel = DatagramChannel.open();
            channel.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            channel.connect(server);
            channel.configureBlocking(false);
            channels.add(channel);
        }
    }

    String run() throws IOException {
        for (int step = 0; step < steps; step++) {
            for (int vehicle = 0; vehicle < pace.vehicles(); vehicle++) {
                long due = pace.dueNanos(vehicle, step);
                Pace.await(due);
                send(vehicle, frames.get(vehicle).next());
                lateness.add(System.nanoTime() - due);
            }
        }
        for (int again = 0; again < FAREWELLS; again++) {
            for (int vehicle = 0; vehicle < pace.vehicles(); vehicle++) {
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
