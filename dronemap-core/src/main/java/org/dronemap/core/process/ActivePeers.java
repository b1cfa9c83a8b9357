package org.dronemap.core.process;

/** Tracks which peer's bytes each thread is processing, so that a crash of the server can be blamed on it. */
public interface ActivePeers {
    /** Nobody wants to know. */
    ActivePeers UNKNOWN = new ActivePeers() {
        @Override
        public void begin(String peer) {
            // Nobody wants to know.
        }

        @Override
        public void done() {
            // Nobody wants to know.
        }
    };

    /** This thread works on bytes of that peer from now on; {@code peer} is {@link PeerPattern#text}. */
    void begin(String peer);

    /** This thread works on nobody's bytes. */
    void done();

    /** Works on bytes of that peer. After an error it counts as still being at it, for that may end the process. */
    default void at(String peer, Runnable work) {
        begin(peer);
        try {
            work.run();
        } catch (RuntimeException e) {
            done();
            throw e;
        }
        done();
    }
}
