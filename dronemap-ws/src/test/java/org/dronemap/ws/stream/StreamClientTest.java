package org.dronemap.ws.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.stream.delivery.TextFrameCache;
import org.dronemap.ws.stream.delivery.WriteReminder;
import org.java_websocket.WebSocket;
import org.java_websocket.exceptions.WebsocketNotConnectedException;
import org.java_websocket.framing.CloseFrame;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A connection that ends while it is written to fails for nobody but its client. */
class StreamClientTest {
    private final List<String> called = new ArrayList<>();

    private WebSocket thatBreaksAt(String call) {
        return (WebSocket) Proxy.newProxyInstance(
                WebSocket.class.getClassLoader(), new Class<?>[] {WebSocket.class}, (proxy, method, arguments) -> {
                    called.add(method.getName());
                    if (method.getName().equals(call)) {
                        throw new WebsocketNotConnectedException();
                    }
                    return method.getReturnType() == boolean.class
                            ? method.getName().equals("isOpen")
                            : null;
                });
    }

    @ParameterizedTest
    @ValueSource(strings = {"isClosed", "isOpen", "hasBufferedData", "sendFrame", "sendPing", "close"})
    void isCutOffAlone(String call) {
        StreamClient client = new StreamClient(thatBreaksAt(call), 0);
        client.outbox().add("news");

        client.probe();
        client.pump(1, new WriteReminder(socket -> {}), new TextFrameCache());
        client.expel(new StreamClient.ClosingMessage(CloseFrame.NORMAL, "over", "{}"));
        client.pump(2, new WriteReminder(socket -> {}), new TextFrameCache());

        assertThat(called).contains(call, "closeConnection");
        assertThat(client.caller()).isEmpty();
    }
}
