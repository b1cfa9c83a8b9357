package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * An endpoint that the server opens to one address or serial device, and reopens with growing pauses when it breaks.
 * While nobody speaks on it, it greets once a second: a vehicle that only answers would stay silent for ever. Its
 * thread reads; sending comes from any.
 */
final class OutboundEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(OutboundEndpoint.class);
    private static final long FIRST_PAUSE_MILLIS = 500;
    private static final long LONGEST_PAUSE_MILLIS = 15_000;
    private static final long STEADY_NANOS = 10_000_000_000L;
    private static final long QUIET_NANOS = 3_000_000_000L;
    private static final long BETWEEN_GREETINGS_NANOS = 1_000_000_000L;
    private static final long READ_MILLIS = 200;
    private static final String ONLY = "the only one";

    private final EndpointUrl url;
    private final OutboundConnection.Connector dialler;
    private final PeerHandler.Factory handlers;
    private final EndpointCounters counters = new EndpointCounters();
    private final PeerRegistry<String> peers;
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(16_384);
    private final CompletableFuture<Boolean> closing = new CompletableFuture<>();
    private final Time time;
    private @Nullable Thread thread;
    private volatile EndpointState state = new EndpointState(EndpointState.Phase.CONNECTING, "It is being connected.");

    OutboundEndpoint(EndpointUrl url, OutboundConnection.Connector dialler, PeerHandler.Factory handlers, Time time) {
        this.url = url;
        this.dialler = dialler;
        this.handlers = handlers;
        peers = new PeerRegistry<>(counters, handlers, new PeerRegistry.Limits(1, 1), time);
        this.time = time;
    }

    OutboundEndpoint start() {
        thread = time.blocking(url.kind().scheme(), this::run);
        return this;
    }

    @Override
    public EndpointUrl url() {
        return url;
    }

    @Override
    public EndpointState state() {
        return state;
    }

    @Override
    public EndpointCounters counters() {
        return counters;
    }

    @Override
    public List<PeerStatus> peers() {
        return peers.status();
    }

    private void run() {
        long pause = FIRST_PAUSE_MILLIS;
        while (!isClosed()) {
            long began = time.nanos();
            try (OutboundConnection dialled = dialler.dial(url)) {
                state = EndpointState.OPEN;
                serve(dialled);
            } catch (IOException | RuntimeException e) {
                pause = time.nanos() - began > STEADY_NANOS ? FIRST_PAUSE_MILLIS : pause;
                failed(e, pause);
            }
            peers.clear();
            pauseFor(pause);
            pause = Math.min(2 * pause, LONGEST_PAUSE_MILLIS);
        }
    }

    private void failed(Exception e, long pauseMillis) {
        if (isClosed() || e instanceof ClosedSelectorException) {
            return;
        }
        String why = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
        String sentence = "No link to " + url + ": " + why + (why.endsWith(".") || why.endsWith("?") ? "" : ".")
                + " It is tried again every " + Math.max(1, pauseMillis / 1000) + " s.";
        if (state.phase() != EndpointState.Phase.FAILED) {
            LOG.warn("{}", sentence);
        }
        state = new EndpointState(EndpointState.Phase.FAILED, sentence);
    }

    private void serve(OutboundConnection open) throws IOException {
        EndpointPeer.Origin place =
                new EndpointPeer.Origin(url, open.isLocal(), url.kind().isDatagram());
        EndpointPeer seat = peers.add(
                ONLY,
                open.address().host(),
                time.nanos(),
                welcome -> new EndpointPeer(place, open.address(), open, welcome));
        if (seat == null) {
            throw new IOException("an earlier line is still held");
        }
        long greetedNanos = time.nanos() - BETWEEN_GREETINGS_NANOS;
        long heardNanos = greetedNanos - QUIET_NANOS;
        while (!isClosed()) {
            long now = time.nanos();
            if (now - heardNanos > QUIET_NANOS && now - greetedNanos >= BETWEEN_GREETINGS_NANOS) {
                greetedNanos = now;
                sendGreeting(open);
            }
            buffer.clear();
            if (open.read(buffer, READ_MILLIS) > 0) {
                buffer.flip();
                heardNanos = time.nanos();
                seat.received(buffer, heardNanos);
            }
        }
    }

    private void sendGreeting(OutboundConnection open) {
        byte[] greeting = handlers.greeting();
        if (greeting.length > 0 && !open.send(greeting)) {
            LOG.debug("{} did not take a greeting", url);
        }
    }

    private void pauseFor(long millis) {
        try {
            Boolean unused = time.await(closing, Duration.ofMillis(millis));
            LOG.debug("{} is closed", url);
        } catch (TimeoutException e) {
            LOG.trace("{} is dialled again", url);
        } catch (ExecutionException e) {
            throw new IllegalStateException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            boolean unused = closing.complete(true);
        }
    }

    private boolean isClosed() {
        return closing.isDone();
    }

    @Override
    public void close() {
        boolean unused = closing.complete(true);
        // The thread looks often, and closes its line itself: closing a device may take its time.
        try {
            if (thread != null) {
                thread.join(1000);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
