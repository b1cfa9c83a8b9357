package org.dronemap.ws.stream.delivery;

import java.util.function.Consumer;
import org.java_websocket.WebSocket;

/**
 * Asks again for messages that wait for a stream client to be written by the WebSocket library. It forgets, when a
 * message comes between its last write and its turning to reading, and would then leave all that follows lying until
 * its own sign of life, half a minute later.
 */
public final class WriteReminder {
    private final Consumer<WebSocket> demand;

    /** {@code demand} has the library write to a socket as soon as it can. */
    public WriteReminder(Consumer<WebSocket> demand) {
        this.demand = demand;
    }

    /** Cheap where nothing waits, and harmless where the peer is only slow. */
    public void remind(WebSocket socket) {
        if (!socket.isClosed() && socket.hasBufferedData()) {
            demand.accept(socket);
        }
    }
}
