package org.dronemap.sim.link;

import java.nio.channels.SelectionKey;

/** The network link of one simulated vehicle to the server. Used by the fleet's thread only. */
interface SimulatorLink {
    /** Sends or drops; never waits. */
    void send(byte[] bytes);

    /** The socket has something: reads it, or goes on connecting or writing. */
    void ready(SelectionKey key);

    /** Looks after a broken connection; called some times a second. */
    void maintain(long nowNanos);

    /** Goes on with a new local port. */
    void renew();

    void close();

    /** Frames that the socket did not take. */
    long dropped();
}
