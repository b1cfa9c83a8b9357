package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Endpoints that come and go at run time. */
class EndpointRegistryTest {
    private static final Duration RETRY = Duration.ofMillis(50);

    private final EndpointRegistry links = new EndpointRegistry(
            new CountingPeerHandlers(), EndpointSecurity.of(DtlsKeys.none()), new RealTime(), RETRY);

    @AfterEach
    void close() {
        links.close();
    }

    private EndpointRegistry.Status only() {
        assertThat(links.all()).hasSize(1);
        return links.all().get(0);
    }

    @Test
    void triesAnEndpointAgainUntilItCanOpen() throws IOException {
        try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            links.retryLater("a", EndpointUrl.parse("tcpserver://127.0.0.1:" + other.getLocalPort()));

            assertThat(only().state().phase()).isEqualTo(EndpointState.Phase.FAILED);
            assertThat(only().state().reason()).contains("taken by another program");
        }
        TestCloud.await(
                Duration.ofSeconds(20), () -> only().state().equals(EndpointState.OPEN), () -> "it is " + only());
    }

    @Test
    void opensNoEndpointTwiceAndForgetsARemovedOne() {
        links.retryLater("a", EndpointUrl.parse("udpserver://127.0.0.1:0"));
        EndpointUrl taken = only().url();

        assertThatThrownBy(() -> links.retryLater("b", taken))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("There is an endpoint " + taken + " already.");
        assertThat(links.remove("a")).isTrue();
        assertThat(links.remove("a")).isFalse();
        links.retryLater("b", taken);
        assertThat(only().state()).isEqualTo(EndpointState.OPEN);
    }

    @ParameterizedTest
    @CsvSource({"udpserver, udp-", "tcpserver, tcp-", "wsserver, WebSocketSelector-"})
    void opensAnEndpointAgainWhoseThreadWasStopped(String kind, String thread) throws IOException {
        links.open("a", EndpointUrl.parse(kind + "://127.0.0.1:0"));
        EndpointUrl before = only().url();
        Set<Thread> its = threads(thread);
        assertThat(its).isNotEmpty();

        its.forEach(EndpointRegistryTest::stop);

        TestCloud.await(
                Duration.ofSeconds(20),
                // A thread that waits for a socket ends when something comes.
                () -> pokes(before) && !threads(thread).isEmpty() && Collections.disjoint(threads(thread), its),
                () -> "it is " + only());
        assertThat(only().url()).isEqualTo(before);
    }

    private static Set<Thread> threads(String name) {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith(name) && thread.isAlive())
                .collect(Collectors.toSet());
    }

    /** What a library may do to a thread, and nobody should. */
    @SuppressWarnings({"deprecation", "removal"})
    private static void stop(Thread thread) {
        thread.stop();
    }

    /** False when nobody listens. */
    private static boolean pokes(EndpointUrl url) {
        InetSocketAddress there = new InetSocketAddress(InetAddress.getLoopbackAddress(), url.port());
        try (DatagramSocket datagrams = new DatagramSocket();
                Socket stream = new Socket()) {
            if (url.kind() == EndpointUrl.Kind.UDPSERVER) {
                datagrams.send(new DatagramPacket(new byte[] {1}, 1, there));
            } else {
                stream.connect(there);
            }
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    @Test
    void asksTheSystemForTheDropsOfAUdpSocket() {
        links.retryLater("a", EndpointUrl.parse("udpserver://127.0.0.1:0"));

        assertThat(only().kernelDrops().isPresent()).isEqualTo(Files.isReadable(Path.of("/proc/net/udp6")));
    }

    @Test
    void readsTheDropsOfOnePortOutOfTheSystemsTables(@TempDir Path proc) throws IOException {
        String head = "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode"
                + " ref pointer drops\n";
        Files.writeString(
                proc.resolve("udp"),
                head + " 1234: 0100007F:38D6 00000000:0000 07 00000000:00000000 00:00000000 00000000     0        0"
                        + " 7001 2 0000000000000000 17\n");
        Files.writeString(
                proc.resolve("udp6"),
                head + " 4321: 0000000000000000FFFF00000100007F:38D7 00000000000000000000000000000000:0000 07"
                        + " 00000000:00000000 00:00000000 00000000     0        0 7002 2 0000000000000000 5\n");

        assertThat(KernelDrops.of(proc, 14_550)).hasValue(17);
        assertThat(KernelDrops.of(proc, 14_551)).hasValue(5);
        assertThat(KernelDrops.of(proc, 14_552)).isEmpty();
    }
}
