package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.time.Worker;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A robot on wheels with a ROSLink bridge, on a link of memory that loses what it is told to: drives on for ever. */
public final class MemoryLinkRobot {
    private static final Duration TICK = Duration.ofMillis(50);
    private static final Duration DELAY = Duration.ofMillis(5);
    private static final int REPORT_TICKS = 4;
    private static final int BEAT_TICKS = 20;
    private static final int MOST_UNDER_WAY = 1_000;
    private static final int FIRST_PORT = 30_000;
    private static final int TURTLEBOT = 8;
    private static final int HEARTBEAT = 0;
    private static final int STATUS = 1;
    private static final int MOTION = 2;
    private static final int TWIST = 100;

    private final Laboratory lab;
    private final int systemId;
    private final SplittableRandom chance;
    private final Worker transit;
    private double loss;
    private double x;
    private double speed;
    private int ticks;
    private int sequence;
    private @Nullable PeerHandler handler;
    private PeerHandler.@Nullable Factory server;

    MemoryLinkRobot(Laboratory lab, int systemId, long seed) {
        this.lab = lab;
        this.systemId = systemId;
        this.chance = new SplittableRandom(seed);
        this.transit = lab.time().worker("link of robot " + systemId, MOST_UNDER_WAY);
        var unused = lab.time().worker("robot " + systemId, 1).every(TICK, TICK, this::tick);
    }

    void attach(PeerHandler.@Nullable Factory links) {
        server = links;
        handler = null;
    }

    /** That share of its datagrams, in each direction, from now on. */
    public void loses(double share) {
        loss = share;
    }

    /** m/s, in truth. */
    public double speed() {
        return speed;
    }

    /** As the server has it; empty: it knows no such robot. */
    public Optional<DroneState> known() {
        return lab.server().house().cloud().drones().stream()
                .filter(state -> state.link().key().systemId() == systemId)
                .findFirst();
    }

    public String id() {
        return known().orElseThrow(() -> new AssertionError("The server does not know it"))
                .id()
                .value();
    }

    private void tick() {
        x += speed * TICK.toMillis() / 1_000.0;
        Map<String, Object> beat = Map.of("type", TURTLEBOT, "name", "robot", "system_status", 2, "mode", 0);
        if (ticks % BEAT_TICKS == 0) {
            say(HEARTBEAT, beat);
        }
        if (ticks % REPORT_TICKS == 0) {
            say(STATUS, beat);
            say(MOTION, Map.of("x", x, "y", 0.5, "z", 0.0, "vx", speed, "vy", 0.0, "vz", 0.0, "wz", 0.0));
        }
        ticks++;
    }

    private void say(int message, Map<String, Object> body) {
        var text = JsonMapper.shared().createObjectNode();
        text.putObject("header")
                .put("roslink_version", 1)
                .put("ros_version", 8)
                .put("system_id", systemId)
                .put("message_id", message)
                .put("sequence_number", ++sequence)
                .put("key", "forever");
        text.setAll((tools.jackson.databind.node.ObjectNode) JsonMapper.shared().valueToTree(body));
        byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
        carry(() -> {
            PeerHandler there = handler();
            if (there != null) {
                there.received(ByteBuffer.wrap(bytes));
            }
        });
    }

    private @Nullable PeerHandler handler() {
        if (handler == null && server != null) {
            handler = server.opened(new Far(), new PeerCounters(new EndpointCounters()));
        }
        return handler;
    }

    private void hear(byte[] bytes) {
        JsonNode message = JsonMapper.shared().readTree(bytes);
        if (message.path("header").path("message_id").asInt() == TWIST) {
            speed = Stream.of("vx", "vy", "vz", "wx", "wy", "wz")
                    .mapToDouble(axis -> message.path(axis).asDouble())
                    .sum();
        }
    }

    private void carry(Runnable delivery) {
        if (chance.nextDouble() >= loss) {
            var unused = transit.after(DELAY, delivery);
        }
    }

    /** The robot as the server sees it. */
    private final class Far implements Peer {
        @Override
        public PeerAddress address() {
            return new PeerAddress("127.0.0.1", FIRST_PORT + systemId);
        }

        @Override
        public String transport() {
            return "udp";
        }

        @Override
        public boolean isLocal() {
            return true;
        }

        @Override
        public boolean isDatagram() {
            return true;
        }

        @Override
        public void send(byte[] frame) {
            carry(() -> hear(frame));
        }
    }
}
