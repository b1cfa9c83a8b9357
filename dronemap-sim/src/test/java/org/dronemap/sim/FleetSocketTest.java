package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.sim.control.SimulatorControlPort;
import org.dronemap.sim.link.SimulatedFleet;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class FleetSocketTest {
    private final java.net.DatagramSocket server = open();
    private final FrameReader reader = new FrameReader();
    private final FrameWriter ground = new FrameWriter(255, 190, 2);
    private final Set<Integer> ports = new HashSet<>();
    private final Set<Integer> systemIds = new HashSet<>();
    private SimulatedFleet fleet = fleet(3);
    private boolean armed;
    private int beats;

    private static java.net.DatagramSocket open() {
        try {
            var socket = new java.net.DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            socket.setSoTimeout(50);
            return socket;
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private SimulatedFleet fleet(int count) {
        return new SimulatedFleetBuilder(
                        SimulatorOptions.parse(List.of(
                                "--count", "" + count,
                                "--connect", "udp://127.0.0.1:" + server.getLocalPort(),
                                "--speedup", "20")),
                        0)
                .build();
    }

    @BeforeEach
    void start() {
        fleet.start();
    }

    @AfterEach
    void stop() {
        fleet.close();
        server.close();
    }

    private void pump(BooleanSupplier until, Consumer<SocketAddress> each) throws IOException {
        long deadline = System.nanoTime() + 20_000_000_000L;
        byte[] buffer = new byte[2048];
        while (!until.getAsBoolean()) {
            assertThat(System.nanoTime()).as("the deadline").isLessThan(deadline);
            var packet = new java.net.DatagramPacket(buffer, buffer.length);
            try {
                server.receive(packet);
            } catch (SocketTimeoutException e) {
                continue;
            }
            reader.read(ByteBuffer.wrap(buffer, 0, packet.getLength()), frame -> see(frame, packet.getPort()));
            each.accept(packet.getSocketAddress());
        }
    }

    private void see(Frame frame, int port) {
        if (frame.messageId() == Heartbeat.ID) {
            beats++;
            ports.add(port);
            systemIds.add(frame.systemId());
            if (frame.systemId() == 2) {
                armed = (Heartbeat.decode(frame).baseMode() & 128) != 0;
            }
        }
    }

    @Test
    void eachVehicleHasAPortOfItsOwnAndAnswersThere() throws IOException {
        pump(() -> ports.size() == 3 && systemIds.equals(Set.of(1, 2, 3)), from -> {});
        byte[] arm = ground.frame(new CommandLong(2, 1, 400, 0, 1, 0, 0, 0, 0, 0, 0));
        pump(() -> armed, from -> send(arm, from));
        assertThat(ports).hasSize(3);
    }

    private void send(byte[] bytes, SocketAddress to) {
        try {
            server.send(new java.net.DatagramPacket(bytes, bytes.length, to));
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @Test
    void aRebootedVehicleComesBackFromANewPort() throws IOException {
        pump(() -> ports.size() == 3, from -> {});
        assertThat(order("fault 2 reboot")).isEqualTo("ok reboot for 1 vehicle");
        pump(() -> ports.size() == 4, from -> {});
        assertThat(systemIds).containsExactlyInAnyOrder(1, 2, 3);
    }

    @Test
    void aSilentFleetSaysNothingUntilItsTimeIsOver() throws IOException {
        pump(() -> beats >= 3, from -> {});
        assertThat(order("fault all silent 20s")).startsWith("ok silent 20s for 3 vehicles");
        int before = beats;
        pump(() -> beats > before + 10, from -> {});
    }

    @Test
    void theControlPortSaysWhatIsWrong() throws IOException {
        assertThat(order("fault 9 crash")).isEqualTo("err no vehicle has system id 9: say list");
        assertThat(order("fault 1 battery 200")).startsWith("err battery wants a percentage within 0 and 100");
        assertThat(order("dance")).isEqualTo("err unknown word 'dance': say help");
    }

    private String order(String line) throws IOException {
        try (SimulatorControlPort control = new SimulatorControlPort(fleet, 0);
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), control.port())) {
            new PrintWriter(socket.getOutputStream(), true, StandardCharsets.UTF_8).println(line);
            return new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))
                    .readLine();
        }
    }

    @Test
    void theCommandLineSaysWhatIsWrong() {
        assertThat(complaint("--count", "0")).contains("--count 0 is not within 1 to 10000");
        assertThat(complaint("--connect", "http://x")).contains("give udp://HOST:PORT or tcp://HOST:PORT");
        assertThat(complaint("--home", "95,8")).contains("latitude within -85 to 85");
        assertThat(complaint("--frobnicate")).contains("unknown option '--frobnicate'");
    }

    private static String complaint(String... arguments) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code =
                SimulatorMain.run(List.of(arguments), System.out, new PrintStream(err, true, StandardCharsets.UTF_8));
        assertThat(code).isEqualTo(2);
        return err.toString(StandardCharsets.UTF_8);
    }
}
