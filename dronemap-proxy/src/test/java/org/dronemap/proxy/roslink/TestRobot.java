package org.dronemap.proxy.roslink;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The other end of the wire in tests: says what a bridge would, and keeps what it is told; heartbeats by themselves. */
final class TestRobot implements AutoCloseable {
    private final int systemId;
    private final String key;
    private final BlockingQueue<JsonNode> orders = new LinkedBlockingQueue<>();
    private final AtomicInteger heartbeats = new AtomicInteger();
    private final AtomicInteger pongs = new AtomicInteger();
    private final int udpPort;
    private DatagramSocket socket;
    private @Nullable WebSocket web;
    private int sequence;

    /** {@code key} as it stands in JSON. */
    TestRobot(int udpPort, int systemId, String key) throws IOException {
        this.udpPort = udpPort;
        this.systemId = systemId;
        this.key = key;
        socket = open("127.0.0.1");
    }

    private DatagramSocket open(String from) throws IOException {
        DatagramSocket opened = new DatagramSocket(0, InetAddress.getByName(from));
        opened.setSoTimeout(100);
        Thread listener = new Thread(() -> listen(opened), "test-robot");
        listener.setDaemon(true);
        listener.start();
        return opened;
    }

    private void listen(DatagramSocket from) {
        DatagramPacket packet = new DatagramPacket(new byte[65_535], 65_535);
        while (!from.isClosed()) {
            try {
                from.receive(packet);
                hear(new String(packet.getData(), 0, packet.getLength(), StandardCharsets.UTF_8));
            } catch (SocketTimeoutException e) {
                // Nothing came; look whether it is closed.
            } catch (IOException e) {
                return;
            }
        }
    }

    private void hear(String text) {
        JsonNode message = JsonMapper.shared().readTree(text);
        if (message.get("header").get("message_id").intValue() == 0) {
            heartbeats.incrementAndGet();
        } else {
            orders.add(message);
        }
    }

    /** From another port, or another host, from now on. */
    void moveTo(String host) throws IOException {
        socket.close();
        socket = open(host);
    }

    int port() {
        return socket.getLocalPort();
    }

    void connect(int port, String path) {
        web = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .buildAsync(URI.create("ws://127.0.0.1:" + port + path), new WebSocket.Listener() {
                    @Override
                    public @Nullable CompletionStage<?> onText(WebSocket socket, CharSequence text, boolean last) {
                        hear(text.toString());
                        socket.request(1);
                        return null;
                    }

                    @Override
                    public @Nullable CompletionStage<?> onPong(WebSocket socket, ByteBuffer payload) {
                        pongs.incrementAndGet();
                        socket.request(1);
                        return null;
                    }
                })
                .join();
    }

    /** As bridges do every 13 s; they give up a connection that does not answer within 10 s. */
    void ping() {
        if (web != null) {
            web.sendPing(ByteBuffer.wrap(new byte[] {13})).join();
        }
    }

    int pongs() {
        return pongs.get();
    }

    void disconnect() {
        if (web != null) {
            web.abort();
            web = null;
        }
    }

    /** How many messages it made so far, by whichever link. */
    int numbered() {
        return sequence;
    }

    String packet(int messageId, String body) {
        return "{\"header\":{\"roslink_version\":1,\"ros_version\":8,\"system_id\":" + systemId + ",\"message_id\":"
                + messageId + ",\"sequence_number\":" + ++sequence + ",\"key\":" + key + "}"
                + (body.isEmpty() ? "" : "," + body) + "}";
    }

    void say(int messageId, String body) throws IOException {
        sayRaw(packet(messageId, body));
    }

    void sayRaw(String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), udpPort));
    }

    void sayOnWeb(int messageId, String body) {
        if (web != null) {
            web.sendText(packet(messageId, body), true).join();
        }
    }

    void beat(int type) throws IOException {
        say(0, "\"type\":" + type + ",\"name\":\"robot\",\"system_status\":2,\"owner_id\":1,\"mode\":0");
    }

    /** The next order of that kind; null when none comes in time. */
    @Nullable
    JsonNode order(int messageId, long millis) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
        while (true) {
            JsonNode order = orders.poll(Math.max(0, end - System.nanoTime()), TimeUnit.NANOSECONDS);
            if (order == null || order.get("header").get("message_id").intValue() == messageId) {
                return order;
            }
        }
    }

    /** All that it was told since it was last asked. */
    List<JsonNode> told() {
        List<JsonNode> told = new ArrayList<>();
        orders.drainTo(told);
        return told;
    }

    int ordersWaiting() {
        return orders.size();
    }

    /** How many of the cloud's came so far. */
    int heartbeats() {
        return heartbeats.get();
    }

    @Override
    public void close() {
        disconnect();
        socket.close();
    }
}
