package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ByteChannel;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import org.dronemap.core.link.ClientHost;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.java_websocket.WebSocketAdapter;
import org.java_websocket.WebSocketImpl;
import org.java_websocket.WebSocketServerFactory;
import org.java_websocket.drafts.Draft;
import org.java_websocket.enums.ReadyState;
import org.java_websocket.framing.CloseFrame;
import org.java_websocket.server.DefaultSSLWebSocketServerFactory;
import org.jspecify.annotations.Nullable;

/**
 * Creates WebSocket connections for vehicle endpoints and the state stream, with limits per host and until a handshake.
 * Who comes from a host of which some were cut for saying too much is not listened to for a while. Any thread.
 */
public final class BoundedWebSocketFactory implements WebSocketServerFactory {
    private static final int MOST_BYTES_AFTER_FAREWELL = 1_048_576;
    private static final Duration BETWEEN_SWEEPS = Duration.ofMillis(500);

    private final Limits limits;
    private final Supplier<@Nullable SSLContext> tls;
    private final Runnable onRefusal;
    private final LongAdder refused = new LongAdder();
    /** The library wants an executor of this kind. */
    private final ExecutorService handshakes = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "websocket-tls");
        thread.setDaemon(true);
        return thread;
    });

    private final Time time;
    private final Worker sweeps;

    /** Guarded by this: who is there, by host. Closed ones go at the next sweep, or when a host has too many. */
    private final Map<ClientHost, List<Bounded>> hosts = new HashMap<>();

    /** Guarded by this. */
    private final HostBackoff cuts;

    /**
     * The limits of connections and of handshakes.
     *
     * @param perHost connections of one host
     * @param strangersPerHost of these, ones that have not shaken hands
     * @param strangers such ones of all hosts
     * @param handshakeBytes that may be said before
     * @param patience how long the handshake may take, that of TLS included
     * @param longestPause of those who come from a host of which some were cut
     */
    public record Limits(
            int perHost,
            int strangersPerHost,
            int strangers,
            int handshakeBytes,
            Duration patience,
            Duration longestPause) {
        private static final Duration LONGEST_PAUSE = Duration.ofSeconds(4);

        /** For vehicles and other programs. */
        public static final Limits DEFAULT = new Limits(1_000, 100, 400, 16_384, Duration.ofSeconds(10));

        public Limits(int perHost, int strangersPerHost, int strangers, int handshakeBytes, Duration patience) {
            this(perHost, strangersPerHost, strangers, handshakeBytes, patience, LONGEST_PAUSE);
        }

        public Limits with(int connectionsPerHost, Duration longestHandshake) {
            return new Limits(
                    connectionsPerHost, strangersPerHost, strangers, handshakeBytes, longestHandshake, longestPause);
        }
    }

    /** Counts by itself whom it turns away. */
    public BoundedWebSocketFactory(Limits limits, Supplier<@Nullable SSLContext> tls, Time time) {
        this(limits, tls, () -> {}, time);
    }

    /** {@code tls} is asked for each new connection; null: without. {@code onRefusal} counts those turned away. */
    public BoundedWebSocketFactory(Limits limits, Supplier<@Nullable SSLContext> tls, Runnable onRefusal, Time time) {
        this.limits = limits;
        this.tls = tls;
        this.onRefusal = onRefusal;
        this.time = time;
        this.cuts = new HostBackoff(limits.longestPause());
        this.sweeps = time.worker("websocket-door", 1);
        ScheduledTask unused = sweeps.every(BETWEEN_SWEEPS, BETWEEN_SWEEPS, this::sweep);
    }

    @Override
    public WebSocketImpl createWebSocket(WebSocketAdapter server, Draft draft) {
        return new Bounded(server, List.of(draft));
    }

    @Override
    public WebSocketImpl createWebSocket(WebSocketAdapter server, List<Draft> drafts) {
        return new Bounded(server, drafts);
    }

    /** Whom there is no room for finds the connection closed. */
    @Override
    public ByteChannel wrapChannel(SocketChannel channel, SelectionKey key) throws IOException {
        if (!(key.attachment() instanceof Bounded guarded) || !enter(guarded, channel)) {
            refuse();
            channel.close();
            return channel;
        }
        SSLContext context = tls.get();
        ByteChannel made = context == null
                ? channel
                : new DefaultSSLWebSocketServerFactory(context, handshakes).wrapChannel(channel, key);
        guarded.pause(key);
        return made;
    }

    private synchronized boolean enter(Bounded guarded, SocketChannel channel) throws IOException {
        if (!(channel.getRemoteAddress() instanceof InetSocketAddress remote)) {
            return false;
        }
        guarded.host = ClientHost.of(remote.getAddress().getAddress());
        List<Bounded> its = hosts.computeIfAbsent(guarded.host, host -> new ArrayList<>());
        if (its.size() >= Math.min(limits.perHost(), limits.strangersPerHost())) {
            its.removeIf(Bounded::isGone);
        }
        boolean room = its.size() < limits.perHost()
                && its.stream().filter(Bounded::isStranger).count() < limits.strangersPerHost()
                && strangers() < limits.strangers();
        if (room) {
            its.add(guarded);
        }
        return room;
    }

    private long strangers() {
        return hosts.values().stream()
                .flatMap(List::stream)
                .filter(Bounded::isStranger)
                .count();
    }

    private synchronized long pauseNanos(ClientHost host, long now) {
        return cuts.pauseNanos(host, now);
    }

    private synchronized void wasCut(ClientHost host) {
        cuts.add(host, time.nanos());
    }

    /** Turns away who takes too long, listens to who has waited, and forgets who is gone. */
    private void sweep() {
        long now = time.nanos();
        List<Bounded> late = new ArrayList<>();
        synchronized (this) {
            cuts.forget(now);
            hosts.values().stream().flatMap(List::stream).forEach(one -> one.resume(now));
            hosts.values().forEach(its -> its.removeIf(Bounded::isGone));
            hosts.values().removeIf(List::isEmpty);
            hosts.values().stream()
                    .flatMap(List::stream)
                    .filter(one -> one.isStranger()
                            && now - one.sinceNanos > limits.patience().toNanos())
                    .forEach(late::add);
        }
        late.forEach(one -> {
            refuse();
            one.closeConnection(CloseFrame.POLICY_VALIDATION, "the handshake took too long");
        });
    }

    private void refuse() {
        refused.increment();
        onRefusal.run();
    }

    /** Connections that were turned away or cut. */
    public long refusedCount() {
        return refused.sum();
    }

    @Override
    public void close() {
        sweeps.close();
        handshakes.shutdown();
    }

    /** A connection whose handshake has a bound. */
    private final class Bounded extends WebSocketImpl {
        /** When it was listened to first, or will be. */
        private volatile long sinceNanos = time.nanos();

        private @Nullable ClientHost host;
        private volatile @Nullable Runnable listening;
        // owned by the worker that decodes
        private int said;
        private int saidAfterFarewell;
        private boolean cut;

        Bounded(WebSocketAdapter server, List<Draft> drafts) {
            super(server, drafts);
        }

        boolean isStranger() {
            return getReadyState() == ReadyState.NOT_YET_CONNECTED;
        }

        boolean isGone() {
            return isClosed() || (getChannel() != null && !getChannel().isOpen());
        }

        /** What it says stays with the network until its pause is over. */
        void pause(SelectionKey key) {
            long now = time.nanos();
            long pause = host == null ? 0 : pauseNanos(host, now);
            if (pause > 0) {
                int events = key.interestOps();
                key.interestOps(0);
                sinceNanos = now + pause;
                listening = () -> {
                    key.interestOps(events);
                    key.selector().wakeup();
                };
            }
        }

        void resume(long now) {
            Runnable listen = listening;
            if (listen != null && now - sinceNanos >= 0) {
                listening = null;
                try {
                    listen.run();
                } catch (CancelledKeyException e) {
                    // It was closed meanwhile, and goes with the others that are gone.
                }
            }
        }

        private void cutOnce() {
            if (!cut && host != null) {
                cut = true;
                wasCut(host);
            }
        }

        @Override
        public void decode(ByteBuffer bytes) {
            if (isStranger()) {
                said += bytes.remaining();
                if (said > limits.handshakeBytes()) {
                    refuse();
                    cutOnce();
                    bytes.position(bytes.limit());
                    closeConnection(CloseFrame.POLICY_VALIDATION, "the handshake is too long");
                    return;
                }
            }
            if (isClosing()) {
                saidAfterFarewell += bytes.remaining();
                if (saidAfterFarewell > MOST_BYTES_AFTER_FAREWELL) {
                    closeConnection(CloseFrame.ABNORMAL_CLOSE, "it goes on after the farewell");
                }
            }
            super.decode(bytes);
            if (getDraft() instanceof BoundedWebSocketDraft draft && draft.isExceeded()) {
                cutOnce();
            }
        }
    }
}
