package org.dronemap.ws.stream;

import org.java_websocket.framing.CloseFrame;

/** Reason why the connection of a client of the WebSocket stream has ended. */
public enum StreamEnding {
    /** The client ended it. */
    LEFT,
    /** The client ended it because it seemed dead to it, and connects anew. */
    RECONNECTING,
    /** It broke off. */
    BROKEN,
    /** The server ended it. */
    EXPELLED;

    /** With this code a page ends a connection that seems dead to it, to connect anew. */
    private static final int CONNECTS_ANEW = 4000;

    /** {@code remote}: at the client's own wish. */
    static StreamEnding of(int code, boolean remote) {
        if (code == CONNECTS_ANEW) {
            return RECONNECTING;
        }
        if (remote) {
            return LEFT;
        }
        return code == CloseFrame.ABNORMAL_CLOSE ? BROKEN : EXPELLED;
    }
}
