package org.dronemap.proxy.roslink;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.MemoryLink;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A robot on links in memory, in stepped time: says what a bridge would, and keeps what it is told; heartbeats by themselves. */
final class SteppedRobot implements AutoCloseable {
    private static final String HERE = "127.0.0.1";

    private final PeerHandler.Factory handlers;
    private final SteppedTime time;
    private final int systemId;
    private final String key;
    private final Queue<JsonNode> orders = new ArrayDeque<>();
    private int heartbeats;
    private int port;
    private MemoryLink datagrams;
    private @Nullable PeerHandler web;
    private int sequence;

    /** {@code key} as it stands in JSON; {@code port}: where its datagrams come from, the next one its WebSocket. */
    SteppedRobot(PeerHandler.Factory handlers, SteppedTime time, int port, int systemId, String key) {
        this.handlers = handlers;
        this.time = time;
        this.systemId = systemId;
        this.key = key;
        this.port = port;
        datagrams = open();
    }

    private MemoryLink open() {
        return new MemoryLink(handlers, new PeerAddress(HERE, port), this::hear, time);
    }

    private void hear(byte[] bytes) {
        JsonNode message = JsonMapper.shared().readTree(new String(bytes, StandardCharsets.UTF_8));
        if (id(message) == 0) {
            heartbeats++;
        } else {
            orders.add(message);
        }
    }

    /** Its datagrams come from there from now on; where it was, nobody closes anything. */
    void moveTo(int another) {
        port = another;
        datagrams = open();
    }

    int port() {
        return port;
    }

    /** Opens a WebSocket to the bare path. */
    void connect() {
        web = handlers.opened(new WebPeer(port + 1), new PeerCounters(new EndpointCounters()));
    }

    private final class WebPeer implements Peer {
        private final PeerAddress address;

        WebPeer(int port) {
            address = new PeerAddress(HERE, port);
        }

        @Override
        public PeerAddress address() {
            return address;
        }

        @Override
        public String transport() {
            return "websocket";
        }

        @Override
        public boolean isLocal() {
            return true;
        }

        @Override
        public String path() {
            return "/";
        }

        @Override
        public void send(byte[] frame) {
            hear(frame);
        }
    }

    private byte[] packet(int messageId, String body) {
        String text = "{\"header\":{\"roslink_version\":1,\"ros_version\":8,\"system_id\":" + systemId
                + ",\"message_id\":" + messageId + ",\"sequence_number\":" + ++sequence + ",\"key\":" + key + "},"
                + body + "}";
        return text.getBytes(StandardCharsets.UTF_8);
    }

    void say(int messageId, String body) {
        datagrams.received(packet(messageId, body));
    }

    void sayOnWeb(int messageId, String body) {
        if (web != null) {
            web.received(ByteBuffer.wrap(packet(messageId, body)));
        }
    }

    void beat(int type) {
        say(0, "\"type\":" + type + ",\"name\":\"robot\",\"system_status\":2,\"owner_id\":1,\"mode\":0");
    }

    /** The next order of that kind; null when none comes in time. */
    @Nullable
    JsonNode order(int messageId, Duration longest) {
        boolean unused = time.advanceUntil(() -> comesNext(messageId), longest);
        return orders.poll();
    }

    private boolean comesNext(int messageId) {
        while (!orders.isEmpty() && id(orders.element()) != messageId) {
            orders.remove();
        }
        return !orders.isEmpty();
    }

    private static int id(JsonNode order) {
        return order.get("header").get("message_id").intValue();
    }

    /** All that it was told since it was last asked. */
    List<JsonNode> told() {
        List<JsonNode> told = new ArrayList<>(orders);
        orders.clear();
        return told;
    }

    /** How many of the cloud's came so far, by either link. */
    int heartbeats() {
        return heartbeats;
    }

    @Override
    public void close() {
        datagrams.close();
        if (web != null) {
            web.closed();
        }
    }
}
