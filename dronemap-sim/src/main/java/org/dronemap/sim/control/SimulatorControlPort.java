package org.dronemap.sim.control;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletionException;
import org.dronemap.sim.link.SimulatedFleet;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The simulator's TCP port on loopback for test commands (faults, battery, sensors): one line in, one answer out. One
 * daemon thread of its own.
 */
public final class SimulatorControlPort implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(SimulatorControlPort.class);
    private static final int IDLE_MILLIS = 600_000;

    private final SimulatedFleet fleet;
    private final ServerSocket listener;

    /** Listens at {@code port}; 0 takes any free one. */
    public SimulatorControlPort(SimulatedFleet fleet, int port) throws IOException {
        this.fleet = fleet;
        this.listener = new ServerSocket(port, 8, InetAddress.getLoopbackAddress());
        Thread thread = new Thread(this::serve, "control");
        thread.setDaemon(true);
        thread.start();
    }

    public int port() {
        return listener.getLocalPort();
    }

    private void serve() {
        while (!listener.isClosed()) {
            try (Socket client = listener.accept()) {
                client.setSoTimeout(IDLE_MILLIS);
                converse(client);
            } catch (IOException e) {
                if (!listener.isClosed()) {
                    LOG.info("A control client has gone: {}", e.getMessage());
                }
            }
        }
    }

    private void converse(Socket client) throws IOException {
        BufferedReader in = new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.UTF_8));
        PrintWriter out = new PrintWriter(client.getOutputStream(), true, StandardCharsets.UTF_8);
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            out.println(answer(line));
        }
    }

    private String answer(String line) {
        try {
            return fleet.ask(vehicles -> SimulatorControlCommands.run(line, vehicles))
                    .join();
        } catch (CompletionException e) {
            LOG.warn("Control line '{}' failed", line, e);
            return "err " + e.getCause();
        }
    }

    @Override
    public void close() throws IOException {
        listener.close();
    }
}
