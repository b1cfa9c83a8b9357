package org.dronemap.sim.load;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;

/**
 * Load test: sends the messages of all robots at a fixed rate, half of them over WebSockets, the rest over UDP. What
 * they are told is thrown away. One thread.
 */
final class RobotLoadSender {
    private final int robots;
    private final int perSecond;
    private final int steps;
    private final List<Robot> all = new ArrayList<>();
    private final LatencyPercentiles lateness = new LatencyPercentiles();
    private final HttpClient client = HttpClient.newHttpClient();
    private long byUdp;
    private long byWeb;
    private long refused;

    /** One load robot: its messages and its links. */
    private final class Robot {
        private final RobotLoadMessages words;
        private final DatagramChannel udp = DatagramChannel.open();
        private final @Nullable WebSocket web;
        private CompletableFuture<?> sending = CompletableFuture.completedFuture(null);

        Robot(int number, InetSocketAddress server, int webPort) throws IOException {
            words = new RobotLoadMessages(number, perSecond);
            udp.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            udp.connect(server);
            udp.configureBlocking(false);
            web = number % 2 == 0 ? null : connect("ws://127.0.0.1:" + webPort + path(number));
        }

        /** Both addresses that robots call at take turns. */
        private static String path(int number) {
            return number % 4 == 1 ? "/" : "/websockets/roslink/user/1/robot/load-" + number + "/robot";
        }

        void step() throws IOException {
            if (web != null && words.nextIsHeartbeat()) {
                sendByUdp(words.heartbeat());
            }
            send(words.next());
        }

        void farewell() throws IOException {
            send(words.motion());
        }

        private void send(String text) throws IOException {
            if (web == null) {
                sendByUdp(text);
            } else {
                // The one before has left long ago, unless the server does not read.
                sending.join();
                sending = web.sendText(text, true);
                byWeb++;
            }
        }

        private void sendByUdp(String text) throws IOException {
            byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
            if (udp.write(ByteBuffer.wrap(bytes)) == bytes.length) {
                byUdp++;
            } else {
                refused++;
            }
        }

        void close() throws IOException {
            sending.join();
            if (web != null) {
                web.abort();
            }
            udp.close();
        }
    }

    RobotLoadSender(LoadArguments arguments) throws IOException {
        robots = arguments.integer("--robots");
        perSecond = arguments.integer("--rate");
        steps = arguments.integer("--steps");
        InetSocketAddress server = new InetSocketAddress(InetAddress.getLoopbackAddress(), arguments.integer("--port"));
        for (int number = 0; number < robots; number++) {
            all.add(new Robot(number, server, arguments.integer("--web-port")));
        }
    }

    private WebSocket connect(String address) {
        return client.newWebSocketBuilder()
                .buildAsync(URI.create(address), new WebSocket.Listener() {})
                .join();
    }

    /**
     * Says that it is ready, and sends from the time that it is then told. Once told that all of it came it has everybody's
     * heart beat once more, as the robots' numbers are one row for both of their ways, and stays until it is told to end.
     */
    String run(BufferedReader told, PrintStream out) throws IOException {
        out.println("ready");
        String startNanos = told.readLine();
        if (startNanos == null) {
            throw new IllegalArgumentException("nobody said when to start");
        }
        SendSchedule pace = new SendSchedule(Long.parseLong(startNanos.strip()), robots, perSecond);
        for (int step = 0; step < steps; step++) {
            for (int robot = 0; robot < robots; robot++) {
                long due = pace.dueNanos(robot, step);
                SendSchedule.await(due);
                all.get(robot).step();
                lateness.add(System.nanoTime() - due);
            }
        }
        for (Robot robot : all) {
            robot.farewell();
        }
        out.println("said");
        String came = told.readLine();
        for (Robot robot : all) {
            robot.sendByUdp(robot.words.heartbeat());
        }
        out.println("beaten");
        String end = told.readLine();
        for (Robot robot : all) {
            robot.close();
        }
        return "{\"byUdp\":" + byUdp + ",\"byWeb\":" + byWeb + ",\"refused\":" + refused + ",\"toldToEnd\":"
                + (came != null && end != null) + ",\"lateness\":" + lateness.json() + "}";
    }
}
