package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.jspecify.annotations.Nullable;

/**
 * Between one vehicle and whatever server there is: datagrams in both directions, which take their time, and may get lost
 * or overtake each other, by chance with a seed. Frames of both directions go to the log of the flight.
 */
public final class Wire {
    private static final Duration USUAL_DELAY = Duration.ofMillis(5);
    private static final int MOST_UNDER_WAY = 10_000;

    private final Time time;
    private final Worker transit;
    private final SplittableRandom chance;
    private final FlightRecord record;
    private final Consumer<Frame> vehicle;
    private final FrameReader reader = new FrameReader();
    private final String name;
    private Tap tap = Tap.NONE;
    private Quality quality = Quality.GOOD;
    private boolean cut;
    private int port;
    private @Nullable PeerHandler handler;
    private PeerHandler.@Nullable Factory server;

    /** Hears what the vehicle says, and what it is told, before anything of that gets lost. */
    interface Tap {
        Tap NONE = new Tap() {
            @Override
            public void said(byte[] frame) {}

            @Override
            public void told(byte[] frame) {}
        };

        void said(byte[] frame);

        void told(byte[] frame);
    }

    /**
     * How good it is.
     *
     * @param loss the share of datagrams that get lost, 0 to 1, in each direction
     * @param delay how long one takes at least
     * @param scatter and at most so much longer, so that it may be overtaken
     */
    public record Quality(double loss, Duration delay, Duration scatter) {
        /** Nothing gets lost. */
        public static final Quality GOOD = new Quality(0, USUAL_DELAY, Duration.ZERO);
    }

    Wire(String name, int port, Time time, long seed, FlightRecord record, Consumer<Frame> vehicle) {
        this.name = name;
        this.port = port;
        this.time = time;
        this.transit = time.worker("wire of " + name, MOST_UNDER_WAY);
        this.chance = new SplittableRandom(seed);
        this.record = record;
        this.vehicle = vehicle;
    }

    /** That server from now on; null: nobody listens. */
    void attach(PeerHandler.@Nullable Factory handlers) {
        server = handlers;
        handler = null;
    }

    /** From now on. */
    public void is(Quality other) {
        quality = other;
    }

    /** Nothing goes through from now on. */
    public void cut() {
        cut = true;
    }

    /** Again. */
    public void mend() {
        cut = false;
    }

    /** The vehicle has another port from now on, as after a change of its network. */
    public void move() {
        port += 1_000;
        handler = null;
    }

    int port() {
        return port;
    }

    /** Hears both directions from now on. */
    void tap(Tap listener) {
        tap = listener;
    }

    /** What the vehicle says. */
    void up(byte[] bytes) {
        record.said(name, bytes);
        tap.said(bytes);
        carry(() -> {
            PeerHandler there = handler();
            if (there != null) {
                there.received(ByteBuffer.wrap(bytes));
            }
        });
    }

    private @Nullable PeerHandler handler() {
        if (handler == null && server != null) {
            handler = server.opened(
                    new Far(new PeerAddress("127.0.0.1", port)), new PeerCounters(new EndpointCounters()));
        }
        return handler;
    }

    private void down(byte[] bytes) {
        record.told(name, bytes);
        tap.told(bytes);
        carry(() -> reader.read(ByteBuffer.wrap(bytes), frame -> {
            if (frame.verified()) {
                vehicle.accept(frame);
            }
        }));
    }

    private void carry(Runnable delivery) {
        if (cut || chance.nextDouble() < quality.loss()) {
            return;
        }
        long scatter = quality.scatter().toNanos();
        Duration delay = quality.delay().plusNanos(scatter == 0 ? 0 : chance.nextLong(scatter));
        var unused = transit.after(delay, () -> {
            if (!cut) {
                delivery.run();
            }
        });
    }

    /** The vehicle as the server sees it. */
    private final class Far implements Peer {
        private final PeerAddress address;

        Far(PeerAddress address) {
            this.address = address;
        }

        @Override
        public PeerAddress address() {
            return address;
        }

        @Override
        public String transport() {
            return "udp";
        }

        @Override
        public boolean isLocal() {
            return true;
        }

        @Override
        public boolean isDatagram() {
            return true;
        }

        @Override
        public void send(byte[] frame) {
            if (address.port() == port) {
                down(frame);
            }
        }
    }
}
