package org.dronemap.core.process;

/**
 * Goes with whoever takes bytes of peers.
 *
 * @param atWork is told whose bytes are worked on
 * @param precautions says from whom nothing is taken
 */
public record PeerWatch(PeersAtWork atWork, Precautions precautions) {
    /** Nobody wants to know, and all are welcome. */
    public static final PeerWatch NONE = new PeerWatch(PeersAtWork.UNKNOWN, Precautions.NONE);
}
