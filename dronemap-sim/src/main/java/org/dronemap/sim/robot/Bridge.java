package org.dronemap.sim.robot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.dronemap.sim.robot.RobotOptions.Identity;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** One robot's bridge on real sockets: says what its machine reports, and has it do what it is told. Owned by the fleet's thread. */
final class Bridge implements AutoCloseable {
    private static final int HEARTBEAT = 0;
    private static final int STATUS = 1;
    private static final int MOTION = 2;
    private static final int MAP = 6;
    private static final int MOST_WAITING = 64;
    private static final double SECONDS_A_BEAT = 1;

    private final Machine machine;
    private final RobotOptions options;
    private final Speech speech;
    private final DatagramChannel udp;
    private final ByteBuffer inbox = ByteBuffer.allocate(65_535);
    private final Queue<String> fromWeb = new ArrayBlockingQueue<>(MOST_WAITING);
    private @Nullable CompletableFuture<WebSocket> web;
    private CompletableFuture<?> sending = CompletableFuture.completedFuture(null);
    private double sinceBeat = SECONDS_A_BEAT;
    private double sinceReport;
    private boolean deaf;

    Bridge(Machine machine, RobotOptions options, Identity identity, InetSocketAddress server) throws IOException {
        this.machine = machine;
        this.options = options;
        speech = new Speech(identity, options.quirks());
        deaf = options.quirks().contains(Quirk.IGNORES_ORDERS);
        udp = DatagramChannel.open();
        udp.configureBlocking(false);
        udp.connect(server);
    }

    Machine machine() {
        return machine;
    }

    void connect(HttpClient client, URI address) {
        web = client.newWebSocketBuilder().buildAsync(address, new WebSocket.Listener() {
            private final StringBuilder text = new StringBuilder();

            @Override
            public @Nullable CompletionStage<?> onText(WebSocket socket, CharSequence part, boolean last) {
                text.append(part);
                if (last) {
                    // Without room the order is lost, as on any link.
                    fromWeb.offer(text.toString());
                    text.setLength(0);
                }
                socket.request(1);
                return null;
            }
        });
    }

    void turn(double seconds) throws IOException {
        listen();
        machine.move(seconds);
        sinceBeat += seconds;
        sinceReport += seconds;
        if (sinceBeat >= SECONDS_A_BEAT) {
            sinceBeat -= SECONDS_A_BEAT;
            beat();
            say(STATUS, options.quirks().contains(Quirk.STATUS_IS_HEARTBEAT) ? heartbeat() : machine.status());
            for (Map.Entry<Integer, Map<String, Object>> sight :
                    machine.sights().entrySet()) {
                say(sight.getKey(), sight.getValue());
            }
        }
        if (sinceReport >= 1 / options.motionHertz()) {
            sinceReport = 0;
            say(MOTION, machine.motion());
        }
    }

    private void beat() throws IOException {
        say(HEARTBEAT, heartbeat());
        if (isOnWeb() && options.quirks().contains(Quirk.BEATS_ON_BOTH)) {
            sayByUdp(HEARTBEAT, heartbeat());
        }
    }

    private Map<String, Object> heartbeat() {
        return Map.of("type", machine.type(), "name", "simulated", "system_status", 2, "mode", 0);
    }

    private boolean isOnWeb() {
        CompletableFuture<WebSocket> opened = web;
        return opened != null
                && opened.isDone()
                && !opened.isCompletedExceptionally()
                && !opened.join().isOutputClosed();
    }

    private void say(int messageId, Map<String, Object> body) throws IOException {
        CompletableFuture<WebSocket> opened = web;
        if (opened != null && isOnWeb()) {
            // What the link has no room for is not kept: the next report says more.
            if (sending.isDone()) {
                sending = opened.join().sendText(speech.text(messageId, body), true);
            }
        } else {
            sayByUdp(messageId, body);
        }
    }

    private void sayByUdp(int messageId, Map<String, Object> body) throws IOException {
        try {
            udp.write(ByteBuffer.wrap(speech.text(messageId, body).getBytes(StandardCharsets.UTF_8)));
        } catch (java.net.PortUnreachableException e) {
            // Nobody is there yet; the next message tries again.
            inbox.clear();
        }
    }

    private void listen() throws IOException {
        for (String text = fromWeb.poll(); text != null; text = fromWeb.poll()) {
            heard(text);
        }
        while (true) {
            inbox.clear();
            try {
                if (udp.read(inbox) <= 0) {
                    return;
                }
            } catch (java.net.PortUnreachableException e) {
                return;
            }
            inbox.flip();
            heard(StandardCharsets.UTF_8.decode(inbox).toString());
        }
    }

    private void heard(String text) throws IOException {
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
        if (order == Orders.GET_MAP && !machine.map().isEmpty()) {
            say(MAP, machine.map());
        }
        machine.obey(order, speech.body(message));
        deaf = order == Orders.STOP && options.quirks().contains(Quirk.DIES_OF_STOP);
    }

    @Override
    public void close() throws IOException {
        CompletableFuture<WebSocket> opened = web;
        if (opened != null && isOnWeb()) {
            opened.join().abort();
        }
        udp.close();
    }
}
