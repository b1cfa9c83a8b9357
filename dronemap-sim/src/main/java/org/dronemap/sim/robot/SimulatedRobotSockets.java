package org.dronemap.sim.robot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The UDP and WebSocket connections of one simulated robot to the server. Owned by the fleet's thread. */
final class SimulatedRobotSockets implements SimulatedRobot.Links, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(SimulatedRobotSockets.class);
    private static final int MOST_WAITING = 64;

    private final SimulatedRobot robot;
    private final DatagramChannel udp;
    private final ByteBuffer inbox = ByteBuffer.allocate(65_535);
    private final Queue<String> fromWeb = new ArrayBlockingQueue<>(MOST_WAITING);
    private @Nullable CompletableFuture<WebSocket> web;
    private CompletableFuture<?> sending = CompletableFuture.completedFuture(null);

    SimulatedRobotSockets(RobotOptions options, int number, InetSocketAddress server) throws IOException {
        robot = new SimulatedRobot(options, number, this);
        udp = DatagramChannel.open();
        udp.configureBlocking(false);
        udp.connect(server);
    }

    SimulatedRobot robot() {
        return robot;
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

    void advance(double seconds) throws IOException {
        listen();
        robot.advance(seconds);
    }

    @Override
    public boolean isOnWeb() {
        CompletableFuture<WebSocket> opened = web;
        return opened != null
                && opened.isDone()
                && !opened.isCompletedExceptionally()
                && !opened.join().isOutputClosed();
    }

    @Override
    public void sendByWebSocket(Supplier<String> text) {
        CompletableFuture<WebSocket> opened = web;
        // What the link has no room for is not kept: the next report says more.
        if (opened != null && sending.isDone()) {
            sending = opened.join().sendText(text.get(), true);
        }
    }

    @Override
    public void sendByUdp(String text) {
        try {
            udp.write(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
        } catch (java.net.PortUnreachableException e) {
            // Nobody is there yet; the next message tries again.
            inbox.clear();
        } catch (IOException e) {
            LOG.warn("A robot could not speak: {}", e.getMessage());
        }
    }

    private void listen() throws IOException {
        for (String text = fromWeb.poll(); text != null; text = fromWeb.poll()) {
            robot.received(text);
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
            robot.received(StandardCharsets.UTF_8.decode(inbox).toString());
        }
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
