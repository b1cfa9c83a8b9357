package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;

/**
 * Receives the bytes of one peer of an endpoint; implemented for vehicles, robots and outlet clients. Always called on
 * one thread at a time.
 */
public interface PeerHandler {
    /** The buffer is reused: take all of it before returning. */
    void received(ByteBuffer bytes);

    /** The peer has gone, or fell silent for so long that its place was given away. */
    void closed();

    /** Decides who takes the bytes of a new peer. */
    interface Factory {
        PeerHandler opened(Peer peer, PeerCounters counters);

        /** What is said on a link that we dialled while nobody speaks there: many vehicles only answer. Empty: nothing. */
        default byte[] greeting() {
            return new byte[0];
        }

        /** How they speak. */
        default PeerMessageFormat speech() {
            return PeerMessageFormat.FRAMES;
        }

        /** Whether WebSockets to that path are for it; what a path says may be a secret. */
        default boolean acceptsPath(String path) {
            return true;
        }
    }
}
