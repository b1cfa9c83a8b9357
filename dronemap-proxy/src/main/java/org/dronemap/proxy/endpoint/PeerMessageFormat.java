package org.dronemap.proxy.endpoint;

/**
 * The format that an endpoint's peers speak: binary frames or text messages, and how long they may be.
 *
 * @param text WebSocket messages are texts, not frames of bytes
 * @param longestDatagram bytes; what is longer is cut, and so counted as broken
 * @param longestMessage bytes of a WebSocket message; what is longer ends the connection
 */
public record PeerMessageFormat(boolean text, int longestDatagram, int longestMessage) {
    /** Frames of MAVLink: a jumbo frame's worth at most in a datagram. */
    public static final PeerMessageFormat FRAMES = new PeerMessageFormat(false, DatagramQueue.LARGEST_DATAGRAM, 65_536);
}
