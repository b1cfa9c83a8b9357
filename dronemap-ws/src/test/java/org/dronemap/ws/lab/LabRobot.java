package org.dronemap.ws.lab;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.dronemap.core.drone.DroneState;
import org.dronemap.sim.robot.BridgeQuirk;
import org.dronemap.sim.robot.SimulatedRobot;
import org.dronemap.sim.robot.SimulatedRobotFleet;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.wiring.SteppedServer;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** One robot of the laboratory: what it truly does, its links, what it was told, and the drone that the server takes it for. */
public final class LabRobot {
    /** Orders by the numbers that the wire knows them by. */
    public static final int TWIST = 100;

    private static final int HEARTBEAT = 0;

    public static final int ARM = 104;

    private static final Duration TURN = Duration.ofMillis(50);
    private static final double TURN_SECONDS = 0.05;

    private final Laboratory lab;
    private final RobotSpec kit;
    private final SimulatedRobot robot;
    private final LabPeerLink udp;
    private final @Nullable LabPeerLink web;
    private final List<Integer> orders = new ArrayList<>();
    private int heartbeats;
    private int wrong;

    LabRobot(Laboratory lab, RobotSpec kit, int number) {
        this.lab = lab;
        this.kit = kit;
        udp = new LabPeerLink(lab, 50_000 + 2 * number, LabPeerLink.Kind.UDP, SteppedServer::robots, this::told);
        String path = kit.path();
        web = path == null
                ? null
                : new LabPeerLink(
                        lab, 50_001 + 2 * number, LabPeerLink.Kind.webSocket(path), SteppedServer::robots, this::told);
        robot = new SimulatedRobot(kit.options(), 0, new Ways());
        var unused = lab.time()
                .worker("robot " + kit.systemId(), 1)
                .every(Duration.ZERO, TURN, () -> robot.advance(TURN_SECONDS));
    }

    private final class Ways implements SimulatedRobot.Links {
        @Override
        public boolean isOnWeb() {
            return web != null;
        }

        @Override
        public void sendByWebSocket(Supplier<String> text) {
            say(Optional.ofNullable(web).orElseThrow(), text.get());
        }

        @Override
        public void sendByUdp(String text) {
            say(udp, text);
        }

        private void say(LabPeerLink line, String text) {
            line.up(text.getBytes(StandardCharsets.UTF_8));
        }
    }

    private void told(byte[] bytes) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        JsonNode message = JsonMapper.shared().readTree(text);
        JsonNode header = kit.quirks().contains(BridgeQuirk.PAYLOAD_SHAPE) ? message : message.path("header");
        boolean number = kit.quirks().contains(BridgeQuirk.NUMBER_KEY);
        if (header.path("system_id").asInt(-1) != kit.systemId()
                || header.path("key").isNumber() != number
                || !header.path("key").asString("").equals(kit.key())) {
            wrong++;
        }
        int kind = header.path("message_id").asInt(-1);
        if (kind == HEARTBEAT) {
            heartbeats++;
        } else {
            orders.add(kind);
        }
        robot.received(text);
    }

    /** By somebody beside it, whatever it is told by the server. */
    public void isPushed(double speed) {
        ObjectNode twist = JsonMapper.shared().createObjectNode();
        ObjectNode header = twist.putObject("header");
        header.put("system_id", kit.systemId()).put("message_id", TWIST);
        if (kit.quirks().contains(BridgeQuirk.NUMBER_KEY)) {
            header.put("key", Long.parseLong(kit.key()));
        } else {
            header.put("key", kit.key());
        }
        robot.received(twist.put("vx", speed).toString());
    }

    public int systemId() {
        return kit.systemId();
    }

    /** What is true of it. */
    public SimulatedRobotFleet.GroundTruth truth() {
        return robot.truth();
    }

    /** Of the server, so far. */
    public int heartbeats() {
        return heartbeats;
    }

    /** By their numbers, in the order in which they came; without heartbeats. */
    public List<Integer> orders() {
        return List.copyOf(orders);
    }

    /** Messages that came to it with another's key or system id, or with its key written in another way. */
    public int wrong() {
        return wrong;
    }

    /** As that user sees it; empty: not at all. */
    public Optional<DroneView> seenBy(Pilot user) {
        return lab.server().drones().drones(user.principal()).stream()
                .filter(drone -> drone.link().systemId() == kit.systemId())
                .findFirst();
    }

    public DroneView view(Pilot user) {
        return seenBy(user).orElseThrow(() -> new AssertionError("The server does not know robot " + kit.systemId()));
    }

    /** As the server has it. */
    public DroneState state() {
        return lab.server().house().cloud().drones().stream()
                .filter(state -> state.link().key().systemId() == kit.systemId())
                .findFirst()
                .orElseThrow(() -> new AssertionError("The server does not know robot " + kit.systemId()));
    }

    /** Waits until that user may have it do that. */
    public LabRobot allows(Pilot user, String action) {
        lab.until(
                "robot " + kit.systemId() + " is listed, and " + action + " is allowed",
                Duration.ofSeconds(30),
                () -> seenBy(user)
                        .filter(drone -> drone.actions().get(action).allowed())
                        .isPresent());
        return this;
    }

    /** Has it do that, and waits for the end whatever that is. */
    public CommandView.OutcomeView outcome(Pilot user, CommandRequest what) {
        CommandView given = lab.server()
                .commands()
                .submit(user.principal(), "laboratory", state().id().value(), what);
        return Optional.ofNullable(user.end(given).outcome()).orElseThrow();
    }

    /** Has it do that, and insists on success. */
    public LabRobot does(Pilot user, CommandRequest what) {
        CommandView.OutcomeView outcome = outcome(user, what);
        if (!outcome.result().equals("succeeded")) {
            throw new AssertionError(what.kind() + ": " + outcome);
        }
        return this;
    }
}
