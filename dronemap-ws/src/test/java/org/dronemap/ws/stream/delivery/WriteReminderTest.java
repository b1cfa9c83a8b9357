package org.dronemap.ws.stream.delivery;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import org.java_websocket.WebSocket;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WriteReminderTest {
    @ParameterizedTest
    @CsvSource({"true, false, 1", "false, false, 0", "true, true, 0"})
    void remindsWhereSomethingWaitsOfASocketThatIsNotClosed(boolean waits, boolean closed, int times) {
        WebSocket socket = socket(waits, closed);
        List<WebSocket> reminded = new ArrayList<>();

        new WriteReminder(reminded::add).remind(socket);

        assertThat(reminded).hasSize(times);
    }

    private static WebSocket socket(boolean waits, boolean closed) {
        return (WebSocket) Proxy.newProxyInstance(
                WebSocket.class.getClassLoader(),
                new Class<?>[] {WebSocket.class},
                (proxy, method, given) -> switch (method.getName()) {
                    case "hasBufferedData" -> waits;
                    case "isClosed" -> closed;
                    default -> throw new UnsupportedOperationException(method.getName());
                });
    }
}
