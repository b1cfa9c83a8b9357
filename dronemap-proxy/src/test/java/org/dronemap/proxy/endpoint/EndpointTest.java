package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EndpointTest {
    private final AtomicInteger bytes = new AtomicInteger();
    private final AtomicInteger closed = new AtomicInteger();

    private final PeerHandler.Factory counting = (peer, counters) -> new PeerHandler() {
        @Override
        public void received(ByteBuffer received) {
            bytes.addAndGet(received.remaining());
            peer.send(new byte[] {1});
        }

        @Override
        public void closed() {
            closed.incrementAndGet();
        }
    };

    @ParameterizedTest
    @ValueSource(
            strings = {
                "14550",
                "udp://127.0.0.1:14550",
                "udpserver://127.0.0.1:99999",
                "udpserver://:1",
                "udpserver://127.0.0.1:1/path",
                "tcpclient://host:0",
                "serial://ttyUSB0",
                "serial:///dev/ttyUSB0?baud=12",
                "serial:///dev/ttyUSB0?parity=odd",
                "wsclient://host:80/a b",
                ""
            })
    void saysWhatIsWrongWithAUrl(String text) {
        assertThatThrownBy(() -> EndpointUrl.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("\"" + text + "\"");
    }

    @Test
    void readsAUrl() {
        assertThat(EndpointUrl.parse("tcpserver://[::1]:5760"))
                .isEqualTo(new EndpointUrl(EndpointUrl.Kind.TCPSERVER, "[::1]", 5760, "", 0));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "udpserver://0.0.0.0:14550",
                "udpclient://modem.example:14550",
                "tcpclient://10.0.0.1:5760",
                "serial:///dev/serial/by-id/usb-Holybro_Radio-if00?baud=921600",
                "wsserver://127.0.0.1:5770",
                "wsclient://relay.example:80/Fleet/7",
                "wssserver://127.0.0.1:5771",
                "wssclient://relay.example:443/Fleet/7",
                "dtlsserver://[::]:14556"
            })
    void writesAUrlAsItReadsIt(String text) {
        assertThat(EndpointUrl.parse(text)).hasToString(text);
    }

    @Test
    void knowsShorterFormsOfUrls() {
        assertThat(EndpointUrl.parse("udpout://Host:1/")).hasToString("udpclient://host:1");
        assertThat(EndpointUrl.parse("serial:///dev/ttyS0")).hasToString("serial:///dev/ttyS0?baud=57600");
    }

    @ParameterizedTest
    @ValueSource(strings = {"udpserver", "tcpserver", "wsserver", "dtlsserver"})
    void saysThatAPortIsTaken(String scheme) throws IOException {
        try (Endpoint first = Endpoint.open(
                EndpointUrl.parse(scheme + "://127.0.0.1:0"),
                counting,
                EndpointSecurity.of(DtlsKeys.none()),
                new RealTime())) {
            EndpointUrl taken = first.url();

            assertThatThrownBy(
                            () -> Endpoint.open(taken, counting, EndpointSecurity.of(DtlsKeys.none()), new RealTime()))
                    .isInstanceOf(IOException.class)
                    .hasMessage("Cannot listen on " + taken + ": port " + taken.port()
                            + " is taken by another program; stop it or configure another port.");
        }
    }

    @Test
    void answersATcpPeerAndNoticesThatItLeft() throws IOException {
        try (Endpoint endpoint = Endpoint.open(
                EndpointUrl.parse("tcpserver://127.0.0.1:0"),
                counting,
                EndpointSecurity.of(DtlsKeys.none()),
                new RealTime())) {
            try (Socket socket = new Socket("127.0.0.1", endpoint.url().port())) {
                socket.getOutputStream().write(new byte[] {1, 2, 3});
                assertThat(socket.getInputStream().read()).isEqualTo(1);
                assertThat(endpoint.counters().counts().peers()).isEqualTo(1);
            }
            TestCloud.await(Duration.ofSeconds(5), () -> closed.get() == 1, () -> "not noticed");
            assertThat(endpoint.counters().counts().peers()).isZero();
        }
        assertThat(bytes).hasValue(3);
    }
}
