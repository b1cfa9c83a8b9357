package org.dronemap.ws.stream;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.stream.delivery.PublishSchedule;
import org.dronemap.ws.stream.delivery.StreamClientOutbox;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.dronemap.ws.stream.delivery.TextFrameCache;
import org.dronemap.ws.stream.delivery.WriteReminder;
import org.java_websocket.WebSocket;
import org.java_websocket.exceptions.WebsocketNotConnectedException;
import org.java_websocket.framing.CloseFrame;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One client connected to the WebSocket stream, with its caller, subscription and outbox. Any thread; its sending
 * belongs to the pump.
 */
final class StreamClient implements StreamConnection {
    private static final Logger LOG = LoggerFactory.getLogger(StreamClient.class);
    private static final int LONGEST_REASON_BYTES = 123;
    private static final int TOO_SLOW = CloseFrame.TRY_AGAIN_LATER;

    private final WebSocket socket;
    private final StreamClientOutbox outbox = new StreamClientOutbox();
    private final ConcurrentHashMap<StreamMessageSubject, Object> shown = new ConcurrentHashMap<>();
    private volatile boolean greeted;
    private volatile boolean unsettled;
    private final long connectedNanos;
    private volatile long answeredNanos;
    private final ConcurrentHashMap<Class<?>, Object> attachments = new ConcurrentHashMap<>();
    private volatile @Nullable AuthenticatedCaller caller;
    private volatile @Nullable Set<String> wanted;
    private volatile int perSecond = PublishSchedule.MOST_PER_SECOND;
    private volatile long closingSinceNanos;
    private volatile @Nullable ClosingMessage farewell;

    /** The last message to a client, and the code and reason of the close frame after it. */
    record ClosingMessage(int code, String reason, String message) {}

    StreamClient(WebSocket socket, long nowNanos) {
        this.socket = socket;
        this.connectedNanos = nowNanos;
        this.answeredNanos = nowNanos;
    }

    WebSocket socket() {
        return socket;
    }

    Optional<AuthenticatedCaller> caller() {
        return Optional.ofNullable(caller);
    }

    @Override
    public Optional<Principal> principal() {
        return caller().map(AuthenticatedCaller::principal);
    }

    /** Empty until it was greeted: the greeting comes before all news. */
    Optional<Principal> listener() {
        return greeted ? principal() : Optional.empty();
    }

    /** What it hears first is on its way to it. */
    void setGreeted() {
        greeted = true;
    }

    void admit(AuthenticatedCaller who) {
        caller = who;
    }

    long connectedNanos() {
        return connectedNanos;
    }

    @Override
    public void probe() {
        boolean unused = guarded(() -> {
            if (socket.isOpen()) {
                socket.sendPing();
            }
            return true;
        });
    }

    /** A connection may end between any two calls; what comes of that is of this client alone, which is cut off. */
    private boolean guarded(BooleanSupplier work) {
        try {
            return work.getAsBoolean();
        } catch (RuntimeException e) {
            if (e instanceof WebsocketNotConnectedException) {
                LOG.debug("A connection of the stream broke while it was written to", e);
            } else {
                LOG.error("A client of the stream is cut off, as it cannot be served", e);
            }
            caller = null;
            outbox.clear();
            socket.closeConnection(CloseFrame.ABNORMAL_CLOSE, "it cannot be written to");
            return true;
        }
    }

    void answered(long nowNanos) {
        answeredNanos = nowNanos;
    }

    @Override
    public long answeredNanos() {
        return answeredNanos;
    }

    @Override
    public long nowNanos() {
        return System.nanoTime();
    }

    @Override
    public <T> T attachment(Class<T> type, Supplier<T> initial) {
        return type.cast(attachments.computeIfAbsent(type, unused -> initial.get()));
    }

    /** It is nobody any more. */
    void leave() {
        caller = null;
    }

    StreamClientOutbox outbox() {
        return outbox;
    }

    /** Null: all drones. */
    void subscribe(@Nullable List<String> drones) {
        wanted = drones == null ? null : drones.stream().collect(Collectors.toUnmodifiableSet());
    }

    /** At most so many pictures of each drone a second. */
    void slowDown(int pictures) {
        perSecond = pictures;
    }

    int perSecond() {
        return perSecond;
    }

    /** What this client was shown and is told of when it is gone, each as it saw it then ({@link StreamTopic.Sight}). */
    Map<StreamMessageSubject, Object> shown() {
        return shown;
    }

    /** What it was shown is to be compared with what it may see: things may have changed in between. */
    void unsettle() {
        unsettled = true;
    }

    /** True once after {@link #unsettle}. */
    boolean settle() {
        boolean was = unsettled;
        unsettled = false;
        return was;
    }

    /** What it subscribed to are drones, and what is said of them. */
    boolean wants(StreamMessageSubject subject) {
        Set<String> only = wanted;
        return only == null || !subject.isDrone() || only.contains(subject.id());
    }

    /** From now on nothing but this farewell is sent; what was waiting is thrown away. */
    void expel(ClosingMessage last) {
        caller = null;
        farewell = last;
    }

    void close(int code, String reason) {
        if (closingSinceNanos == 0) {
            closingSinceNanos = Math.max(1, System.nanoTime());
            boolean unused = guarded(() -> {
                socket.close(code, fitting(reason));
                return true;
            });
        }
    }

    /** A close frame holds 123 bytes of reason; the whole sentence went out as an error message before. */
    private static String fitting(String reason) {
        String fitting = reason;
        while (fitting.getBytes(StandardCharsets.UTF_8).length > LONGEST_REASON_BYTES) {
            fitting = fitting.substring(0, fitting.length() - 1);
        }
        return fitting;
    }

    /**
     * Hands waiting messages to the socket as soon as it has sent all that it had: its own queue has no bound. False
     * when something still waits.
     */
    boolean pump(long nowNanos, WriteReminder reminder, TextFrameCache frames) {
        return guarded(() -> {
            reminder.remind(socket);
            return pump(nowNanos, frames);
        });
    }

    private boolean pump(long nowNanos, TextFrameCache frames) {
        if (closingSinceNanos != 0) {
            if (nowNanos - closingSinceNanos > 2_000_000_000L) {
                // it does not even take the farewell
                socket.closeConnection(TOO_SLOW, "too slow");
            }
            return true;
        }
        ClosingMessage last = farewell;
        if (last != null) {
            outbox.clear();
            if (socket.isOpen()) {
                socket.send(last.message());
            }
            close(last.code(), last.reason());
            return true;
        }
        if (outbox.isOverflown()) {
            close(
                    TOO_SLOW,
                    "Too slow: more than " + StreamClientOutbox.MOST_DISCRETE + " messages were waiting; reconnect.");
            return true;
        }
        if (socket.isOpen() && !socket.hasBufferedData()) {
            socket.sendFrame(frames.of(outbox.drain()));
        }
        return outbox.isEmpty();
    }
}
