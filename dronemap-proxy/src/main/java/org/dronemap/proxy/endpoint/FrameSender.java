package org.dronemap.proxy.endpoint;

/**
 * Sends frames (or texts) to one peer of an endpoint without ever blocking. Any thread; never waits for the other side.
 */
@FunctionalInterface
interface FrameSender {
    /** Puts one whole frame on its way; false when there was no room and it was dropped. */
    boolean send(byte[] frame);

    /** Frames that wait to be sent. */
    default int waiting() {
        return 0;
    }

    /** The peer has lost its place. */
    default void close() {
        // A datagram socket serves others too.
    }
}
