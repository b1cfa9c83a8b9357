package org.dronemap.sim.load;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** The bad network: what it loses, doubles, delays and renames, by its seed. */
class ImpairerTest {
    private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

    @Test
    void relaysBothWaysWithTheDelayAsked() throws IOException {
        try (DatagramSocket server = socket();
                DatagramSocket vehicle = socket();
                Impairer impairer = new Impairer(0, server.getLocalPort(), new Impairment(100, 20, 0, 0, 0), 0, 1)) {
            long sent = System.nanoTime();
            send(vehicle, impairer.port(), "up");
            DatagramPacket there = receive(server);
            assertThat(text(there)).isEqualTo("up");
            assertThat(millisSince(sent)).isBetween(80L, 1_000L);
            server.send(new DatagramPacket("down".getBytes(StandardCharsets.US_ASCII), 4, there.getSocketAddress()));
            assertThat(text(receive(vehicle))).isEqualTo("down");
            assertThat(millisSince(sent)).isGreaterThanOrEqualTo(160L);
        }
    }

    @Test
    void losesTheShareAskedAndTheSameOnesForOneSeed() {
        assertThat(survivors(7)).isEqualTo(survivors(7)).isNotEqualTo(survivors(8));
        assertThat(survivors(7).size()).isBetween(850, 950);
    }

    private static List<Integer> survivors(long seed) {
        Impairment spoiling = new Impairment(0, 0, 0.1, 0, 0);
        Random chance = new Random(seed);
        List<Integer> survivors = new ArrayList<>();
        for (int number = 0; number < 1_000; number++) {
            if (spoiling.copies(chance) > 0) {
                survivors.add(number);
            }
        }
        return survivors;
    }

    @Test
    void doublesAndHoldsBack() {
        Random chance = new Random(3);
        assertThat(new Impairment(0, 0, 0, 1, 0).copies(chance)).isEqualTo(2);
        assertThat(new Impairment(10, 0, 0, 0, 1).delayNanos(chance)).isEqualTo(30_000_000L);
        for (int i = 0; i < 100; i++) {
            assertThat(new Impairment(10, 5, 0, 0, 0).delayNanos(chance)).isBetween(5_000_000L, 15_000_000L);
        }
    }

    @Test
    void givesAVehicleANewAddressAfterItsTime() throws IOException {
        try (DatagramSocket server = socket();
                DatagramSocket vehicle = socket();
                Impairer impairer = new Impairer(0, server.getLocalPort(), new Impairment(0, 0, 0, 0, 0), 0.001, 1)) {
            Set<Integer> ports = new HashSet<>();
            for (int i = 0; i < 20; i++) {
                send(vehicle, impairer.port(), "hello");
                ports.add(receive(server).getPort());
            }
            assertThat(ports).hasSizeGreaterThan(1);
            assertThat(impairer.json()).contains("\"lost\":0");
        }
    }

    @Test
    void refusesWhatNoNetworkDoes() {
        assertThatThrownBy(() -> new Impairment(10, 20, 0, 0, 0)).hasMessageContaining("jitter");
        assertThatThrownBy(() -> new Impairment(10, 5, 1.5, 0, 0)).hasMessageContaining("probability");
    }

    private static DatagramSocket socket() throws IOException {
        DatagramSocket socket = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0));
        socket.setSoTimeout(5_000);
        return socket;
    }

    private static void send(DatagramSocket from, int port, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        from.send(new DatagramPacket(bytes, bytes.length, LOOPBACK, port));
    }

    private static DatagramPacket receive(DatagramSocket at) throws IOException {
        DatagramPacket packet = new DatagramPacket(new byte[100], 100);
        try {
            at.receive(packet);
        } catch (SocketTimeoutException e) {
            throw new AssertionError("nothing came", e);
        }
        return packet;
    }

    private static String text(DatagramPacket packet) {
        return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII);
    }

    private static long millisSince(long nanos) {
        return (System.nanoTime() - nanos) / 1_000_000;
    }
}
