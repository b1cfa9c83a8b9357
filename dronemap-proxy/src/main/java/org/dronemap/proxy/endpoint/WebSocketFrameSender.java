package org.dronemap.proxy.endpoint;

import java.nio.charset.StandardCharsets;
import org.java_websocket.WebSocket;
import org.java_websocket.WebSocketImpl;
import org.java_websocket.exceptions.WebsocketNotConnectedException;
import org.java_websocket.framing.CloseFrame;

/** Sends frames to one peer over a WebSocket, and drops new ones while 256 are waiting. */
record WebSocketFrameSender(WebSocket socket, boolean text) implements FrameSender {
    private static final int MOST_WAITING = 256;

    WebSocketFrameSender(WebSocket socket) {
        this(socket, false);
    }

    @Override
    public boolean send(byte[] frame) {
        if (waiting() >= MOST_WAITING) {
            return false;
        }
        try {
            if (text) {
                socket.send(new String(frame, StandardCharsets.UTF_8));
            } else {
                socket.send(frame);
            }
            return true;
        } catch (WebsocketNotConnectedException e) {
            return false;
        }
    }

    @Override
    public int waiting() {
        return socket instanceof WebSocketImpl connection ? connection.outQueue.size() : 0;
    }

    @Override
    public void close() {
        socket.close(CloseFrame.GOING_AWAY, "silent for too long, or the endpoint was closed");
    }
}
