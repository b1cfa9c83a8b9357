package org.dronemap.ws.testserver;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicInteger;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Speaks to a server from an address of this machine that nobody else speaks from: what it does is held against nobody. */
public final class LoopbackAddressClient {
    private static final AtomicInteger ADDRESSES = new AtomicInteger();
    private static final int PATIENCE_MILLIS = 30_000;

    private final JsonMapper json = new JsonMapper();
    private final TestServer server;
    private final InetAddress address;

    /** The status, and the body where it is JSON. */
    public record Answer(int status, JsonNode json) {
        public String text(String field) {
            return json.path(field).asString("");
        }
    }

    public LoopbackAddressClient(TestServer server) {
        int number = ADDRESSES.incrementAndGet();
        this.server = server;
        try {
            this.address = InetAddress.getByAddress(new byte[] {127, 1, (byte) (number >> 8), (byte) number});
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public Answer post(String path, String body) {
        byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
        String head = "POST " + path + " HTTP/1.0\r\nHost: localhost\r\nContent-Type: application/json\r\n"
                + "Content-Length: " + bytes.length + "\r\n\r\n";
        try (Socket socket = new Socket(InetAddress.getByName("127.0.0.1"), server.httpPort(), address, 0)) {
            socket.setSoTimeout(PATIENCE_MILLIS);
            ByteArrayOutputStream request = new ByteArrayOutputStream();
            request.write(head.getBytes(StandardCharsets.US_ASCII));
            request.write(bytes);
            request.writeTo(socket.getOutputStream());
            return answer(new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Without pieces, as an answer to the older version of HTTP is. */
    private Answer answer(String text) {
        int status = Integer.parseInt(text.split(" ", 3)[1]);
        String body = text.substring(text.indexOf("\r\n\r\n") + 4);
        return new Answer(status, body.startsWith("{") ? json.readTree(body) : json.createObjectNode());
    }
}
