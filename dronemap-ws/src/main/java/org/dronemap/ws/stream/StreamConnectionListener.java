package org.dronemap.ws.stream;

/** Listener for the comings and goings of clients of the WebSocket stream; a feature declares its own, as a bean. */
public interface StreamConnectionListener {
    /**
     * Its client is nobody any more: it was shown out, or the connection has ended; both may be told, one after the other.
     * {@link StreamConnection#principal} is empty by then. Any thread.
     */
    default void left(StreamConnection connection) {}

    /** The connection has ended; told after {@link #left}. Any thread. */
    default void disconnected(StreamConnection connection, StreamEnding ending) {}

    /** A round of the thread that sends: many times a second while something goes on. */
    default void round(long nowNanos) {}
}
