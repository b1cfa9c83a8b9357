package org.dronemap.ws.limit;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import org.apache.coyote.Processor;
import org.apache.coyote.Request;
import org.apache.tomcat.util.net.NioChannel;
import org.apache.tomcat.util.net.NioEndpoint;
import org.apache.tomcat.util.net.SocketWrapperBase;
import org.dronemap.core.link.ClientHost;
import org.jspecify.annotations.Nullable;

/**
 * Tomcat's socket endpoint with a time limit for TLS handshake and request head, and a limit of connections per host.
 * The server itself starts its clock anew with each byte: a client that says one every few seconds would stay for ever.
 * Here the head of a request, and the handshake of TLS, have one clock, and a host has so many connections.
 */
final class BoundedNioEndpoint extends NioEndpoint {
    private static final long BETWEEN_SWEEPS_MILLIS = 500;

    private final LongAdder cut = new LongAdder();
    private final LongAdder turnedAway = new LongAdder();
    /** Of TLS, and since when; owned by the sweep. */
    private final Map<SocketWrapperBase<NioChannel>, Long> handshakes = new WeakHashMap<>();

    private volatile ClientLimits limits = ClientLimits.DEFAULT;
    private @Nullable ScheduledFuture<?> sweeping;

    void limits(ClientLimits wanted) {
        limits = wanted;
    }

    /** Clients that took too long for the head of a request. */
    long cutCount() {
        return cut.sum();
    }

    /** Connections beyond what a host may have. */
    long turnedAwayCount() {
        return turnedAway.sum();
    }

    @Override
    public void startInternal() throws Exception {
        super.startInternal();
        sweeping = getUtilityExecutor()
                .scheduleWithFixedDelay(
                        this::sweep, BETWEEN_SWEEPS_MILLIS, BETWEEN_SWEEPS_MILLIS, TimeUnit.MILLISECONDS);
    }

    @Override
    public void stopInternal() {
        ScheduledFuture<?> sweep = sweeping;
        if (sweep != null) {
            sweep.cancel(false);
        }
        super.stopInternal();
    }

    @Override
    protected boolean setSocketOptions(SocketChannel socket) {
        if (hasRoomFor(socket)) {
            return super.setSocketOptions(socket);
        }
        turnedAway.increment();
        destroySocket(socket);
        return false;
    }

    private boolean hasRoomFor(SocketChannel socket) {
        int allowed = limits.connectionsPerHost();
        if (connections.size() < allowed) {
            return true;
        }
        ClientHost host = hostOf(socket);
        return host != null
                && connections.keySet().stream()
                                .filter(other -> host.equals(hostOf(other)))
                                .count()
                        < allowed;
    }

    private static @Nullable ClientHost hostOf(SocketChannel socket) {
        try {
            return socket.getRemoteAddress() instanceof InetSocketAddress remote
                    ? ClientHost.of(remote.getAddress().getAddress())
                    : null;
        } catch (IOException closed) {
            return null;
        }
    }

    private void sweep() {
        long now = System.nanoTime();
        Duration patience = limits.patience();
        for (SocketWrapperBase<NioChannel> client : getConnections()) {
            if (isLate(client, now, patience.toNanos())) {
                close(client, patience);
            }
        }
    }

    /** Whoever is being read from right now is looked at again in the next round. */
    private void close(SocketWrapperBase<NioChannel> client, Duration patience) {
        if (!client.getLock().tryLock()) {
            return;
        }
        try {
            if (isLate(client, System.nanoTime(), patience.toNanos())) {
                cut.increment();
                client.close();
            }
        } finally {
            client.getLock().unlock();
        }
    }

    private boolean isLate(SocketWrapperBase<NioChannel> client, long now, long patienceNanos) {
        if (client.getSocket() != null && !client.getSocket().isHandshakeComplete()) {
            return now - handshakes.computeIfAbsent(client, unused -> now) > patienceNanos;
        }
        handshakes.remove(client);
        // Between requests there is none; with the lock held nobody is at work on it, so it waits for more of a head.
        if (!(client.getCurrentProcessor() instanceof Processor processor) || processor.isAsync()) {
            return false;
        }
        Request request = processor.getRequest();
        return request != null && request.getStartTimeNanos() > 0 && now - request.getStartTimeNanos() > patienceNanos;
    }
}
