package org.dronemap.core.process;

/**
 * Guards code that processes bytes of peers: tracks the peer at work, and knows which peers safe mode refuses.
 *
 * @param atWork is told whose bytes are worked on
 * @param precautions says from whom nothing is taken
 */
public record PeerCrashGuard(ActivePeers atWork, SafeMode precautions) {
    /** Nobody wants to know, and all are welcome. */
    public static final PeerCrashGuard NONE = new PeerCrashGuard(ActivePeers.UNKNOWN, SafeMode.NONE);
}
