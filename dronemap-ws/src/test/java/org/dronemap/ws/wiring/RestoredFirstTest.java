package org.dronemap.ws.wiring;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Closeable;
import java.io.IOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.link.SavedEndpoint;
import org.dronemap.core.process.ActivePeers;
import org.dronemap.core.process.PeerCrashGuard;
import org.dronemap.core.process.ProcessCrash;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.process.SafeMode;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.store.memory.MemoryStores;
import org.dronemap.ws.server.ServerBuilder;
import org.dronemap.ws.server.ShutdownSequence;
import org.dronemap.ws.settings.ServerSettings;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * No vehicle hears anything of a server before that knows again who had control of what, where nobody flies, and what was under
 * way: a vehicle that hears it waits with its fail-safe for whoever is not there yet. On real sockets, by every kind of way in.
 */
class RestoredFirstTest {
    private static final int LISTENS_MILLIS = 50;
    private static final int ROUNDS = 16;
    private static final int MOST_ROUNDS = 400;
    private static final int FIRST_PORT = 21_000;
    private static final int LAST_PORT = 30_000;
    private static final String ROBOT = "{\"header\":{\"roslink_version\":1,\"ros_version\":8,\"system_id\":7,"
            + "\"message_id\":0,\"sequence_number\":1,\"key\":\"12\"},\"type\":8}";

    @TempDir
    private Path folder;

    private final ShutdownSequence closing = new ShutdownSequence();
    private final MemoryStores kept = new MemoryStores();
    private final List<Caller> callers = new ArrayList<>();
    private int tcp;
    private int webSocket;
    private int robotsWebSocket;
    private int dtls;
    private ServerSocket dialled;

    /** Says the same again and again from a port of its own, and counts what it hears. */
    private static final class Caller implements AutoCloseable {
        private final DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        private final byte[] words;
        private final int port;
        private int heard;

        Caller(byte[] words) throws IOException {
            this.words = words;
            socket.setSoTimeout(LISTENS_MILLIS);
            port = freeDatagramPort();
        }

        String url() {
            return "udpserver://127.0.0.1:" + port;
        }

        void call() throws IOException {
            socket.send(new DatagramPacket(words, words.length, InetAddress.getLoopbackAddress(), port));
            try {
                socket.receive(new DatagramPacket(new byte[2_048], 2_048));
                heard++;
            } catch (SocketTimeoutException e) {
                // Nobody says anything.
            }
        }

        @Override
        public void close() {
            socket.close();
        }
    }

    @BeforeEach
    void call() throws IOException {
        callers.add(new Caller(heartbeat(21)));
        callers.add(new Caller(heartbeat(22)));
        callers.add(new Caller(ROBOT.getBytes(StandardCharsets.UTF_8)));
        dialled = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        dialled.setSoTimeout(LISTENS_MILLIS);
        tcp = freePort();
        webSocket = freePort();
        robotsWebSocket = freePort();
        dtls = freeDatagramPort();
        kept.links().addLink(new SavedEndpoint("stored", callers.get(1).url(), "ann", Instant.EPOCH));
        kept.links()
                .addLink(new SavedEndpoint(
                        "dialled", "tcpclient://127.0.0.1:" + dialled.getLocalPort(), "ann", Instant.EPOCH));
    }

    private static byte[] heartbeat(int systemId) {
        return new FrameWriter(systemId, 1, 2).frame(new Heartbeat(2, 3, 81, 0, 3, 3));
    }

    private static int freePort() throws IOException {
        return free(port -> new ServerSocket(port, 1, InetAddress.getLoopbackAddress()));
    }

    private static int freeDatagramPort() throws IOException {
        return free(port -> new DatagramSocket(port, InetAddress.getLoopbackAddress()));
    }

    private interface Binding {
        Closeable bind(int port) throws IOException;
    }

    /** Below those that systems hand out: nobody gets it by chance until the server opens it. */
    private static int free(Binding binding) throws IOException {
        while (true) {
            int port = ThreadLocalRandom.current().nextInt(FIRST_PORT, LAST_PORT);
            try (Closeable bound = binding.bind(port)) {
                assertThat(bound).isNotNull();
                return port;
            } catch (BindException e) {
                // Another one, then.
            }
        }
    }

    @AfterEach
    void close() throws IOException {
        closing.close();
        callers.forEach(Caller::close);
        dialled.close();
    }

    @ParameterizedTest
    @CsvSource({
        "LeaseStore.leases, false",
        "ZoneStore.zones, false",
        "VirtualDroneStore.virtualDrones, false",
        "OperationStore.underWay, false",
        "GrantStore.directory, false",
        "CommandStore.endUnfinished, false",
        "ZoneStore.zones, true",
        "VirtualDroneStore.virtualDrones, true",
        "OperationStore.underWay, true"
    })
    void nobodyHearsAnythingBeforeThatIsRead(String read, boolean careful) throws Exception {
        BlockingStores held = new BlockingStores(kept, read);
        ServerBuilder builder =
                new ServerBuilder(settings(), closing, new RealTime(), careful ? careful() : ProcessStart.ORDINARY);
        CompletableFuture<Void> start = CompletableFuture.runAsync(() -> {
            builder.open(held.stores());
            builder.openLinks();
        });
        try {
            held.awaitAsked();
            for (int round = 0; round < ROUNDS; round++) {
                callAll();
            }
            assertThat(callers).extracting(caller -> caller.heard).containsOnly(0);
            assertThat(start.isDone()).isFalse();
            assertThat(isDialled()).isFalse();
            assertThat(openPorts()).isEmpty();
        } finally {
            held.release();
            // Also where the test fails: else its folder goes while the server writes there.
            start.get(30, TimeUnit.SECONDS);
        }
        for (int round = 0; round < MOST_ROUNDS && callers.stream().anyMatch(caller -> caller.heard == 0); round++) {
            callAll();
        }
        assertThat(callers).extracting(caller -> caller.heard).doesNotContain(0);
        assertThat(isDialled()).isTrue();
        assertThat(openPorts()).containsExactly("tcp", "webSocket", "robotsWebSocket", "dtls");
    }

    private void callAll() throws IOException {
        for (Caller caller : callers) {
            caller.call();
        }
    }

    private boolean isDialled() throws IOException {
        try (Socket came = dialled.accept()) {
            return came.isConnected();
        } catch (SocketTimeoutException e) {
            return false;
        }
    }

    /** Of those that nobody calls at here: whoever takes one gets it as long as the server has not opened it. */
    private List<String> openPorts() throws IOException {
        Binding byTcp = port -> new ServerSocket(port, 1, InetAddress.getLoopbackAddress());
        List<String> open = new ArrayList<>();
        addIfTaken(open, "tcp", tcp, byTcp);
        addIfTaken(open, "webSocket", webSocket, byTcp);
        addIfTaken(open, "robotsWebSocket", robotsWebSocket, byTcp);
        addIfTaken(open, "dtls", dtls, port -> new DatagramSocket(port, InetAddress.getLoopbackAddress()));
        return open;
    }

    private static void addIfTaken(List<String> open, String name, int port, Binding binding) throws IOException {
        try (Closeable free = binding.bind(port)) {
            assertThat(free).isNotNull();
        } catch (BindException e) {
            open.add(name);
        }
    }

    /** As after three ends within two minutes. */
    private static ProcessStart careful() {
        ProcessCrash end = new ProcessCrash(Instant.EPOCH, "lane-0", "It ended with ThreadDeath.", List.of());
        return new ProcessStart(
                end, new PeerCrashGuard(ActivePeers.UNKNOWN, new SafeMode(List.of(end, end, end), Set.of())));
    }

    private ServerSettings settings() {
        return ServerSettings.fromEnvironment(Map.of(
                "DRONEMAP_DATA_DIR",
                folder.toString(),
                "DRONEMAP_ENDPOINTS",
                String.join(
                        ",",
                        callers.get(0).url(),
                        "tcpserver://127.0.0.1:" + tcp,
                        "wsserver://127.0.0.1:" + webSocket,
                        "dtlsserver://127.0.0.1:" + dtls),
                "DRONEMAP_ROBOTS",
                callers.get(2).url() + ",wsserver://127.0.0.1:" + robotsWebSocket));
    }
}
