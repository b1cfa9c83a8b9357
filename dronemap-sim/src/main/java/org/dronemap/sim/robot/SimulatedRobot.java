package org.dronemap.sim.robot;

import java.util.Map;
import java.util.function.Supplier;
import org.dronemap.sim.robot.RobotOptions.Identity;
import org.dronemap.sim.robot.SimulatedRobotFleet.GroundTruth;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * One simulated ROSLink robot with its bridge: sends its reports to the server and obeys orders. Not thread-safe: owned
 * by whoever gives it its turns.
 */
public final class SimulatedRobot {
    private static final int HEARTBEAT = 0;
    private static final int STATUS = 1;
    private static final int MOTION = 2;
    private static final int MAP = 6;
    private static final double SECONDS_A_BEAT = 1;
    private static final double LATITUDE = 47.3977;
    private static final double LONGITUDE = 8.5456;

    private final SimulatedRobotMachine machine;
    private final RobotOptions options;
    private final SimulatedRobotCodec speech;
    private final Links links;
    private double sinceBeat = SECONDS_A_BEAT;
    private double sinceReport;
    private boolean deaf;
    /** The server was heard and is not missed yet. */
    private boolean accompanied;

    private double sinceCloud;

    /** Its ways to the server. */
    public interface Links {
        /** Whether it has a WebSocket now, and speaks by that. */
        boolean isOnWeb();

        /** What the link has no room for is not even made: it has no number then. */
        void sendByWebSocket(Supplier<String> text);

        void sendByUdp(String text);
    }

    /** {@code number}: which of those that the options tell of, from 0. */
    public SimulatedRobot(RobotOptions options, int number, Links links) {
        this.options = options;
        this.links = links;
        machine = machine(options, number);
        speech = new SimulatedRobotCodec(identity(options, number), options.quirks());
        deaf = options.quirks().contains(BridgeQuirk.IGNORES_ORDERS);
    }

    static Identity identity(RobotOptions options, int number) {
        return options.first().plus(number);
    }

    private static SimulatedRobotMachine machine(RobotOptions options, int number) {
        boolean flies = options.kind().equals("drone") || (options.kind().equals("mixed") && number % 2 == 1);
        return flies
                ? new SimulatedMavrosDrone(LATITUDE + number * 1e-4, LONGITUDE)
                : new SimulatedRover(-2, -1 + number % 3, options.quirks());
    }

    /** What is true of it now. */
    public GroundTruth truth() {
        return machine.truth();
    }

    /** Lives on for so long, and says what is due. */
    public void advance(double seconds) {
        missCloud(seconds);
        machine.move(seconds);
        sinceBeat += seconds;
        sinceReport += seconds;
        if (sinceBeat >= SECONDS_A_BEAT) {
            sinceBeat -= SECONDS_A_BEAT;
            beat();
            send(STATUS, options.quirks().contains(BridgeQuirk.STATUS_IS_HEARTBEAT) ? heartbeat() : machine.status());
            machine.images().forEach(this::send);
        }
        if (sinceReport >= 1 / options.motionHertz()) {
            sinceReport = 0;
            send(MOTION, machine.motion());
        }
    }

    private void missCloud(double seconds) {
        sinceCloud += seconds;
        double patience = options.cloudPatienceSeconds();
        if (accompanied && patience > 0 && sinceCloud >= patience) {
            accompanied = false;
            machine.cloudLost();
        }
    }

    private void beat() {
        send(HEARTBEAT, heartbeat());
        if (links.isOnWeb() && options.quirks().contains(BridgeQuirk.BEATS_ON_BOTH)) {
            links.sendByUdp(speech.text(HEARTBEAT, heartbeat()));
        }
    }

    private Map<String, Object> heartbeat() {
        return Map.of("type", machine.type(), "name", "simulated", "system_status", 2, "mode", 0);
    }

    private void send(int messageId, Map<String, Object> body) {
        if (links.isOnWeb()) {
            links.sendByWebSocket(() -> speech.text(messageId, body));
        } else {
            links.sendByUdp(speech.text(messageId, body));
        }
    }

    /** It is told something, by either link. */
    public void received(String text) {
        JsonNode message;
        try {
            message = JsonMapper.shared().readTree(text);
        } catch (JacksonException e) {
            return;
        }
        int order = speech.order(message);
        if (deaf || order < 0) {
            return;
        }
        accompanied = true;
        sinceCloud = 0;
        if (order == RobotOrderIds.HEARTBEAT) {
            return;
        }
        if (order == RobotOrderIds.GET_MAP && !machine.map().isEmpty()) {
            send(MAP, machine.map());
        }
        machine.execute(order, speech.body(message));
        deaf = order == RobotOrderIds.STOP && options.quirks().contains(BridgeQuirk.DIES_OF_STOP);
    }
}
