package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.api.Test;

/** A serial line over a pseudo-terminal, which Python makes: its standard streams are the other end of the cable. */
class SerialConnectionTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);
    private static final String CABLE = """
            import os, select, sys, tty
            end, other = os.openpty()
            tty.setraw(end); tty.setraw(other)
            os.write(1, (os.ttyname(other) + chr(10)).encode())
            while True:
                for ready in select.select([0, end], [], [])[0]:
                    data = os.read(ready, 4096)
                    if not data: sys.exit()
                    os.write(end if ready == 0 else 1, data)
            """;

    private final CountingPeerHandlers gathering = new CountingPeerHandlers();

    private static Process cable() throws IOException {
        return new ProcessBuilder("python3", "-c", CABLE)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private static String line(Process cable) throws IOException {
        StringBuilder name = new StringBuilder();
        for (int letter = cable.getInputStream().read();
                letter != '\n';
                letter = cable.getInputStream().read()) {
            name.append((char) letter);
        }
        return name.toString();
    }

    @Test
    void carriesBytesBothWaysAndCallsThePeerAfterTheDevice() throws IOException {
        Process cable = cable();
        String device = line(cable);
        try (Endpoint endpoint = Endpoint.open(
                EndpointUrl.parse("serial://" + device + "?baud=115200"),
                gathering,
                EndpointSecurity.of(DtlsKeys.none()),
                new RealTime())) {
            byte[] greeting = cable.getInputStream().readNBytes(CountingPeerHandlers.GREETING.length);
            cable.getOutputStream().write(new byte[] {1, 2, 3});
            cable.getOutputStream().flush();
            TestCloud.await(PATIENCE, () -> gathering.bytes() == 3, () -> "not heard");

            assertThat(greeting).isEqualTo(CountingPeerHandlers.GREETING);
            Peer peer = gathering.guests().get(0).peer();
            assertThat(peer.address()).isEqualTo(new PeerAddress(device, 0));
            assertThat(peer.transport()).isEqualTo("serial");
            assertThat(peer.isLocal()).isTrue();
            assertThat(endpoint.state()).isEqualTo(EndpointState.OPEN);
        } finally {
            cable.destroy();
        }
    }

    @Test
    void saysThatTheDeviceIsGoneAndKeepsTrying() throws IOException {
        Process cable = cable();
        String device = line(cable);
        try (Endpoint endpoint = Endpoint.open(
                EndpointUrl.parse("serial://" + device),
                gathering,
                EndpointSecurity.of(DtlsKeys.none()),
                new RealTime())) {
            TestCloud.await(PATIENCE, () -> endpoint.state().equals(EndpointState.OPEN), () -> "not open");
            cable.destroy();
            TestCloud.await(
                    PATIENCE,
                    () -> endpoint.state().phase() == EndpointState.Phase.FAILED,
                    () -> "it is " + endpoint.state());

            assertThat(endpoint.state().reason()).contains(device);
            assertThat(gathering.guests().get(0).isClosed()).isTrue();
        }
    }

    @Test
    void dropsAndCountsFramesThatTheDeviceDoesNotTake() throws IOException {
        Process cable = cable();
        String device = line(cable);
        try (Endpoint endpoint = Endpoint.open(
                EndpointUrl.parse("serial://" + device),
                gathering,
                EndpointSecurity.of(DtlsKeys.none()),
                new RealTime())) {
            TestCloud.await(PATIENCE, () -> !gathering.guests().isEmpty(), () -> "not open");
            Peer peer = gathering.guests().get(0).peer();
            // Nobody reads the other end's output: its pipe fills, then the terminal, then the queue.
            for (int count = 0; count < 2_000; count++) {
                peer.send(new byte[280]);
            }

            assertThat(endpoint.counters().counts().droppedOut()).isPositive();
            assertThat(endpoint.peers().get(0).queue()).isLessThanOrEqualTo(64);
        } finally {
            cable.destroy();
        }
    }

    @Test
    void saysThatThereIsNoDevice() throws IOException {
        try (Endpoint endpoint = Endpoint.open(
                EndpointUrl.parse("serial:///dev/ttyNONE9"),
                gathering,
                EndpointSecurity.of(DtlsKeys.none()),
                new RealTime())) {
            TestCloud.await(
                    PATIENCE,
                    () -> endpoint.state().phase() == EndpointState.Phase.FAILED,
                    () -> "it is " + endpoint.state());

            assertThat(endpoint.state().reason()).contains("there is no device /dev/ttyNONE9");
        }
    }
}
