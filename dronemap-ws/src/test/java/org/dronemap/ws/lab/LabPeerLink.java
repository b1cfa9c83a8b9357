package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.Function;
import org.dronemap.core.time.Worker;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.MemoryLink;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.ws.wiring.SteppedServer;
import org.jspecify.annotations.Nullable;

/**
 * Between a ground station or a robot and whatever server there is: bytes in both directions, which take their time.
 * Datagrams may get lost or overtake each other, by chance with a seed; what comes over a connection does not.
 */
public final class LabPeerLink {
    private static final int MOST_UNDER_WAY = 100_000;

    private final Laboratory lab;
    private final PeerAddress address;
    private final Kind kind;
    private final Function<SteppedServer, PeerHandler.Factory> door;
    private final Consumer<byte[]> end;
    private final Worker transit;
    private final SplittableRandom chance;
    private LabVehicleLink.Quality quality = LabVehicleLink.Quality.GOOD;
    private @Nullable SteppedServer server;
    private @Nullable Way way;

    /** How bytes go over it; {@code path}: to which a WebSocket is opened. */
    public record Kind(String transport, boolean isDatagram, String path) {
        public static final Kind UDP = new Kind("udp", true, "");
        public static final Kind TCP = new Kind("tcp", false, "");

        public static Kind webSocket(String path) {
            return new Kind("websocket", false, path);
        }
    }

    /** To one server, from the first byte on until it ends. */
    private interface Way {
        void up(byte[] bytes);

        void close();
    }

    LabPeerLink(
            Laboratory lab,
            int port,
            Kind kind,
            Function<SteppedServer, PeerHandler.Factory> door,
            Consumer<byte[]> end) {
        this.lab = lab;
        this.address = new PeerAddress("127.0.0.1", port);
        this.kind = kind;
        this.door = door;
        this.end = end;
        transit = lab.time().worker("line of " + port, MOST_UNDER_WAY);
        chance = new SplittableRandom(lab.seed() * 1_000_003 + port);
        lab.add(this);
    }

    /** Where it seems to be for the server. */
    public PeerAddress address() {
        return address;
    }

    /** From now on. */
    public void is(LabVehicleLink.Quality other) {
        quality = other;
    }

    /** That server from now on; null: nobody listens. */
    void attach(@Nullable SteppedServer next) {
        // What a server that has died held is gone without a word.
        server = next;
        way = null;
    }

    /** Ends it, as by the end of a program; what is said later opens it again. */
    public void close() {
        if (way != null) {
            way.close();
            way = null;
        }
    }

    void up(byte[] bytes) {
        lab.record().said(address.toString(), bytes);
        carry(() -> {
            Way there = way();
            if (there != null) {
                there.up(bytes);
            }
        });
    }

    private void down(byte[] bytes) {
        lab.record().told(address.toString(), bytes);
        carry(() -> end.accept(bytes));
    }

    private void carry(Runnable delivery) {
        if (kind.isDatagram() && chance.nextDouble() < quality.loss()) {
            return;
        }
        long scatter = kind.isDatagram() ? quality.scatter().toNanos() : 0;
        Duration delay = quality.delay().plusNanos(scatter == 0 ? 0 : chance.nextLong(scatter));
        var unused = transit.after(delay, delivery);
    }

    private @Nullable Way way() {
        if (way == null && server != null) {
            PeerHandler.Factory handlers = door.apply(server);
            way = kind.isDatagram() ? new Datagrams(handlers) : new Connection(handlers);
        }
        return way;
    }

    private final class Datagrams implements Way {
        private final MemoryLink link;

        Datagrams(PeerHandler.Factory handlers) {
            link = new MemoryLink(handlers, address, LabPeerLink.this::down, lab.time());
        }

        @Override
        public void up(byte[] bytes) {
            link.received(bytes);
        }

        /** Nobody tells the server; it notices when nothing comes any more. */
        @Override
        public void close() {}
    }

    private final class Connection implements Way, Peer {
        private final PeerHandler handler;
        private boolean closed;

        Connection(PeerHandler.Factory handlers) {
            handler = handlers.opened(this, new PeerCounters(new EndpointCounters()));
        }

        @Override
        public void up(byte[] bytes) {
            handler.received(ByteBuffer.wrap(bytes));
        }

        @Override
        public void close() {
            closed = true;
            handler.closed();
        }

        @Override
        public PeerAddress address() {
            return address;
        }

        @Override
        public String transport() {
            return kind.transport();
        }

        @Override
        public boolean isLocal() {
            return true;
        }

        @Override
        public String path() {
            return kind.path();
        }

        @Override
        public void send(byte[] frame) {
            if (!closed) {
                down(frame);
            }
        }
    }
}
