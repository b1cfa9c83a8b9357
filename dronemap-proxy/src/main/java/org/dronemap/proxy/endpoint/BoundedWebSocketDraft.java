package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;
import java.util.List;
import org.java_websocket.WebSocket;
import org.java_websocket.WebSocketImpl;
import org.java_websocket.drafts.Draft;
import org.java_websocket.drafts.Draft_6455;
import org.java_websocket.enums.Opcode;
import org.java_websocket.exceptions.InvalidDataException;
import org.java_websocket.exceptions.LimitExceededException;
import org.java_websocket.extensions.IExtension;
import org.java_websocket.framing.Framedata;
import org.java_websocket.protocols.Protocol;

/**
 * WebSocket protocol (RFC 6455) of the Java-WebSocket library with a size limit on messages while they are received.
 * Whoever is not known yet has a tighter bound. Two things that peers could pile up without it: pieces that hold
 * nothing, and answers to pings that they do not read.
 */
public final class BoundedWebSocketDraft extends Draft_6455 {
    /** Bytes of one message of somebody unknown: more than any proof of who they are has. */
    public static final int STRANGERS_BYTES = 8_192;

    private static final int MOST_PONGS_WAITING = 64;

    private final int longestMessage;
    private final WebSocketMessageMeter meter = new WebSocketMessageMeter();
    private volatile int most;
    private volatile boolean exceeded;

    /** Its messages may have {@code longestMessage} bytes; those of a stranger {@link #STRANGERS_BYTES} at most. */
    public BoundedWebSocketDraft(int longestMessage) {
        this(longestMessage, Math.min(longestMessage, STRANGERS_BYTES));
    }

    private BoundedWebSocketDraft(int longestMessage, int most) {
        super(List.<IExtension>of(), List.of(new Protocol("")), longestMessage);
        this.longestMessage = longestMessage;
        this.most = most;
    }

    /** For a connection to somebody whom we chose ourselves. */
    static BoundedWebSocketDraft ofOurChoice(int longestMessage) {
        return new BoundedWebSocketDraft(longestMessage, longestMessage);
    }

    /** Whoever is at the other end is known from now on. Any thread. */
    public static void admit(WebSocket socket) {
        if (socket.getDraft() instanceof BoundedWebSocketDraft draft) {
            draft.most = draft.longestMessage;
        }
    }

    /** Whether more was announced than a message may have, for which the connection ends. Any thread. */
    boolean isExceeded() {
        return exceeded;
    }

    @Override
    public Draft copyInstance() {
        return new BoundedWebSocketDraft(longestMessage, most);
    }

    @Override
    public List<Framedata> translateFrame(ByteBuffer bytes) throws InvalidDataException {
        int bound = most;
        if (!meter.fits(bytes.duplicate(), bound)) {
            exceeded = true;
            throw new LimitExceededException("a message may have " + bound + " bytes", bound);
        }
        return super.translateFrame(bytes);
    }

    @Override
    public void processFrame(WebSocketImpl socket, Framedata frame) throws InvalidDataException {
        if (frame.getOpcode() != Opcode.PING || socket.outQueue.size() < MOST_PONGS_WAITING) {
            super.processFrame(socket, frame);
        }
    }

    // Two connections never share what they have said so far.
    @Override
    public boolean equals(Object other) {
        return this == other;
    }

    @Override
    public int hashCode() {
        return System.identityHashCode(this);
    }
}
