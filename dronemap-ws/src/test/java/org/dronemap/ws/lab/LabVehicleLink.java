package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
public final class LabVehicleLink {
    private static final Duration USUAL_DELAY = Duration.ofMillis(5);
    private static final int MOST_UNDER_WAY = 10_000;

    private final Time time;
    private final Worker transit;
    private final SplittableRandom chance;
    private final FlightFingerprint record;
    private final Consumer<Frame> vehicle;
    private final FrameReader reader = new FrameReader();
    private final LinkTraffic traffic = new LinkTraffic();
    private final String name;
    private final EndpointCounters counters = new EndpointCounters();
    private final List<Stray> strays = new ArrayList<>();
    private final Map<Integer, Long> leftAt = new HashMap<>();
    private Kind kind = Kind.UDP;
    private Quality quality = Quality.GOOD;
    private final List<Capture> captures = new ArrayList<>();
    private final List<LinkTap> taps = new ArrayList<>();
    private double doubled;
    private boolean cut;
    private boolean silentUpwards;
    private int port;
    private @Nullable LinkFrameLog log;
    private @Nullable Far far;
    private @Nullable PeerHandler handler;
    private PeerHandler.@Nullable Factory server;

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

        /** A tenth gets lost each way, and what arrives is late by 0.3 to 0.7 s. */
        public static final Quality BAD = new Quality(0.1, Duration.ofMillis(300), Duration.ofMillis(400));

        /** Nothing gets lost, and all is late. */
        public static Quality late(long millis) {
            return new Quality(0, Duration.ofMillis(millis), Duration.ZERO);
        }
    }

    /**
     * What the server takes it for.
     *
     * @param host where the vehicle is, or the device that it hangs on
     * @param isLocal nobody else can be there
     * @param identity what the link itself proves; null: nothing
     */
    public record Kind(
            String transport,
            String host,
            boolean isLocal,
            @Nullable String identity) {
        private static final String HERE = "127.0.0.1";

        public static final Kind UDP = new Kind("udp", HERE, true, null);
        public static final Kind TCP = new Kind("tcp", HERE, true, null);
        public static final Kind WEBSOCKET = new Kind("websocket", HERE, true, null);

        public static Kind serial(String device) {
            return new Kind("serial", device, true, null);
        }

        /** Opened with the key of that identity. */
        public static Kind dtls(String identity) {
            return new Kind("dtls", "198.51.100.7", false, identity);
        }

        /** Datagrams from somewhere in the network. */
        public static Kind remote(String host) {
            return new Kind("udp", host, false, null);
        }

        boolean isDatagram() {
            return transport.equals("udp") || transport.equals("dtls");
        }

        boolean hasPort() {
            return !transport.equals("serial");
        }
    }

    /**
     * What still came to an address that the vehicle had left.
     *
     * @param after how long ago it had left
     */
    public record Stray(Duration after, Frame frame) {}

    LabVehicleLink(String name, int port, Time time, long seed, FlightFingerprint record, Consumer<Frame> vehicle) {
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
        far = null;
    }

    /** To be said before anything went over it. */
    public void is(Kind other) {
        kind = other;
    }

    /** From now on. */
    public void is(Quality other) {
        quality = other;
    }

    /** So large a share of datagrams arrives twice from now on, 0 to 1. */
    public void doubles(double share) {
        doubled = share;
    }

    /** Hears what is said at both ends from now on. */
    public LinkTap tap() {
        LinkTap tap = new LinkTap(time::nanos);
        taps.add(tap);
        return tap;
    }

    /** Nothing goes through from now on. */
    public void cut() {
        cut = true;
    }

    /** Again. */
    public void mend() {
        cut = false;
    }

    /** Nothing of what the vehicle says goes through any more, though it hears; or it does again. */
    public void isSilentUpwards(boolean now) {
        silentUpwards = now;
    }

    /** The vehicle has another port from now on, as after a change of its network. What proves itself stays the same link. */
    public void move() {
        leftAt.put(port, time.nanos());
        port += 1_000;
        if (kind.identity() == null) {
            handler = null;
            far = null;
        }
    }

    /** The connection ends, and the vehicle opens another one when it speaks next. */
    public void reconnect() {
        if (handler != null) {
            handler.closed();
        }
        move();
    }

    /** Where the vehicle is now; 0 where there are no ports. */
    public int port() {
        return kind.hasPort() ? port : 0;
    }

    /** What came to addresses after they were left, in the order of time. */
    public List<Stray> strays() {
        return List.copyOf(strays);
    }

    /** What the server's side of it has counted. */
    public EndpointCounters.Counts counts() {
        return counters.counts();
    }

    /** Hears the very bytes that come out at the vehicle's socket from now on, with the time in ns. */
    public interface Capture {
        void told(long nanos, byte[] bytes);
    }

    public void capturedBy(Capture socket) {
        captures.add(socket);
    }

    /** All that goes over it from now on. */
    public LinkFrameLog log() {
        LinkFrameLog begun = new LinkFrameLog(time);
        log = begun;
        return begun;
    }

    /** What was said on it so far. */
    public LinkTraffic traffic() {
        return traffic;
    }

    /** What the vehicle says. */
    void up(byte[] bytes) {
        record.said(name, bytes);
        taps.forEach(tap -> tap.said(bytes));
        traffic.add(true, time.nanos(), bytes);
        if (silentUpwards) {
            return;
        }
        carry(() -> {
            PeerHandler there = handler();
            if (there != null) {
                note(true, bytes);
                there.received(ByteBuffer.wrap(bytes));
            }
        });
    }

    private void note(boolean up, byte[] bytes) {
        if (log != null) {
            log.add(up, bytes);
        }
    }

    private @Nullable PeerHandler handler() {
        if (handler == null && server != null) {
            far = new Far();
            handler = server.opened(far, new PeerCounters(counters));
        }
        if (far != null) {
            far.address = new PeerAddress(kind.host(), port());
        }
        return handler;
    }

    private void down(byte[] bytes) {
        record.told(name, bytes);
        captures.forEach(capture -> capture.told(time.nanos(), bytes));
        taps.forEach(tap -> tap.told(bytes));
        note(false, bytes);
        traffic.add(false, time.nanos(), bytes);
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
        deliver(delivery);
        if (doubled > 0 && chance.nextDouble() < doubled) {
            deliver(delivery);
        }
    }

    private void deliver(Runnable delivery) {
        long scatter = quality.scatter().toNanos();
        Duration delay = quality.delay().plusNanos(scatter == 0 ? 0 : chance.nextLong(scatter));
        var unused = transit.after(delay, () -> {
            if (!cut) {
                delivery.run();
            }
        });
    }

    private void stray(byte[] bytes, long leftNanos) {
        Duration after = Duration.ofNanos(time.nanos() - leftNanos);
        new FrameReader().read(ByteBuffer.wrap(bytes), frame -> strays.add(new Stray(after, frame)));
    }

    /** The vehicle as the server sees it. */
    private final class Far implements Peer {
        private PeerAddress address = new PeerAddress(kind.host(), port());

        @Override
        public PeerAddress address() {
            return address;
        }

        @Override
        public String transport() {
            return kind.transport();
        }

        @Override
        public Optional<String> authenticatedIdentity() {
            return Optional.ofNullable(kind.identity());
        }

        @Override
        public boolean isLocal() {
            return kind.isLocal();
        }

        @Override
        public boolean isDatagram() {
            return kind.isDatagram();
        }

        @Override
        public void send(byte[] frame) {
            Long left = leftAt.get(address.port());
            if (left == null) {
                down(frame);
            } else {
                stray(frame, left);
            }
        }
    }
}
