package org.dronemap.sim.robot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.dronemap.sim.robot.RobotOptions.Identity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs all simulated ROSLink robots on one thread. */
public final class SimulatedRobotFleet implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(SimulatedRobotFleet.class);
    private static final int TURN_MILLIS = 50;

    private final List<SimulatedRobotSockets> bridges = new ArrayList<>();
    private final ScheduledExecutorService thread =
            Executors.newSingleThreadScheduledExecutor(task -> new Thread(task, "robots"));
    private final HttpClient client = HttpClient.newHttpClient();

    public SimulatedRobotFleet(RobotOptions options) throws IOException {
        InetSocketAddress server =
                new InetSocketAddress(options.server().host(), options.server().port());
        for (int number = 0; number < options.count(); number++) {
            SimulatedRobotSockets bridge = new SimulatedRobotSockets(options, number, server);
            URI web = options.web();
            if (web != null) {
                bridge.connect(client, web(web, SimulatedRobot.identity(options, number)));
            }
            bridges.add(bridge);
        }
    }

    private static URI web(URI pattern, Identity identity) {
        String owner = Objects.requireNonNullElse(identity.owner(), "0");
        return URI.create(pattern.toString()
                .replace("%7Bkey%7D", URLEncoder.encode(identity.key(), StandardCharsets.UTF_8))
                .replace("%7Bowner%7D", URLEncoder.encode(owner, StandardCharsets.UTF_8)));
    }

    public void start() {
        var unused = thread.scheduleAtFixedRate(this::turn, 0, TURN_MILLIS, TimeUnit.MILLISECONDS);
    }

    private void turn() {
        for (SimulatedRobotSockets bridge : bridges) {
            try {
                bridge.advance(TURN_MILLIS / 1_000.0);
            } catch (IOException e) {
                LOG.warn("A robot could not speak: {}", e.getMessage());
            }
        }
    }

    /** What is true of each robot now: a picture made between two turns. Waits for it. */
    public List<GroundTruth> truths() {
        return CompletableFuture.supplyAsync(
                        () -> bridges.stream()
                                .map(bridge -> bridge.robot().truth())
                                .toList(),
                        thread)
                .join();
    }

    /** The true pose and speed of a robot, in metres, m/s or rad/s; a ground robot is never armed. */
    public record GroundTruth(double x, double y, double height, double speed, boolean armed) {}

    @Override
    public void close() throws IOException {
        thread.shutdownNow();
        for (SimulatedRobotSockets bridge : bridges) {
            bridge.close();
        }
    }
}
