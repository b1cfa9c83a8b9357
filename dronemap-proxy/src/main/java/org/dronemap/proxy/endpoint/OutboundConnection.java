package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * One open connection or serial line that the server opened to a single vehicle or router. Read by one thread; sending
 * by any.
 */
interface OutboundConnection extends FrameSender, AutoCloseable {
    PeerAddress address();

    boolean isLocal();

    /** Bytes read; 0 when {@code patienceMillis} passed without any. A failure, or the other side's leaving, is thrown. */
    int read(ByteBuffer into, long patienceMillis) throws IOException;

    @Override
    void close();

    /** Makes the connection; blocks as long as that takes. */
    interface Connector {
        OutboundConnection dial(EndpointUrl url) throws IOException;
    }
}
