package org.dronemap.ws.testserver;

import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.dronemap.ws.wiring.StreamPort;
import org.java_websocket.client.WebSocketClient;
import org.java_websocket.enums.Opcode;
import org.java_websocket.handshake.ServerHandshake;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A client of the stream that keeps all it hears. */
public final class RecordingStreamClient implements AutoCloseable {
    private final List<JsonNode> heard = new CopyOnWriteArrayList<>();
    private final CompletableFuture<String> closed = new CompletableFuture<>();
    private final CompletableFuture<Void> opened = new CompletableFuture<>();
    private final JsonMapper json = new JsonMapper();
    private final WebSocketClient socket;

    private RecordingStreamClient(TestServer house, String query, Map<String, String> headers) {
        URI address =
                URI.create("ws://127.0.0.1:" + house.bean(StreamPort.class).number() + "/stream" + query);
        socket = new WebSocketClient(address, headers) {
            @Override
            public void onOpen(ServerHandshake handshake) {
                opened.complete(null);
            }

            @Override
            public void onMessage(String message) {
                heard.add(json.readTree(message));
            }

            @Override
            public void onClose(int code, String reason, boolean remote) {
                closed.complete(reason);
            }

            @Override
            public void onError(Exception e) {
                closed.completeExceptionally(e);
            }
        };
        try {
            // One that was opened and closed at once was reached.
            if (!socket.connectBlocking(10, TimeUnit.SECONDS) && !opened.isDone()) {
                throw new IllegalStateException("the stream cannot be reached");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    public static RecordingStreamClient withKey(TestServer house, String key) {
        return new RecordingStreamClient(house, "", Map.of("Authorization", "Bearer " + key));
    }

    public static RecordingStreamClient with(TestServer house, String query, Map<String, String> headers) {
        return new RecordingStreamClient(house, query, headers);
    }

    public void send(String message) {
        socket.send(message);
    }

    /** One message in pieces of at most so many bytes. */
    public void sendInPieces(String message, int most) {
        byte[] all = message.getBytes(StandardCharsets.UTF_8);
        for (int from = 0; from < all.length; from += most) {
            int length = Math.min(most, all.length - from);
            socket.sendFragmentedFrame(Opcode.TEXT, ByteBuffer.wrap(all, from, length), from + length == all.length);
        }
    }

    public List<JsonNode> heard() {
        return List.copyOf(heard);
    }

    public JsonNode await(Predicate<JsonNode> wanted) {
        return ConditionWait.until("a message of the stream", () -> {
            boolean over = closed.isDone();
            Optional<JsonNode> found = heard.stream().filter(wanted).findFirst();
            if (over && found.isEmpty()) {
                throw new IllegalStateException("the stream was closed before such a message came");
            }
            return found;
        });
    }

    /** The reason that the server gave. */
    public String awaitClose() {
        return ConditionWait.until("the stream closes", () -> Optional.ofNullable(closed.getNow(null)));
    }

    @Override
    public void close() {
        socket.close();
    }
}
