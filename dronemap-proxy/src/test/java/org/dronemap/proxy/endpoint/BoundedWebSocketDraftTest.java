package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Arrays;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A message is bounded as it grows at the ports for vehicles (frames of bytes) and for robots (texts). */
class BoundedWebSocketDraftTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);
    private static final int LONGEST = 65_536;
    private static final int TOO_BIG = 1009;
    private static final byte[] PROOF_OF_A_ROBOT = {'{', '}'};
    private static final byte[] KILOBYTE = blank(1_024);

    private static byte[] blank(int length) {
        byte[] bytes = new byte[length];
        Arrays.fill(bytes, (byte) ' ');
        return bytes;
    }

    private static Endpoint open(CountingPeerHandlers gathering, boolean text) throws IOException {
        PeerHandler.Factory handlers = new PeerHandler.Factory() {
            @Override
            public PeerHandler opened(Peer peer, PeerCounters counters) {
                PeerHandler guest = gathering.opened(peer, counters);
                return new PeerHandler() {
                    @Override
                    public void received(ByteBuffer bytes) {
                        if (text && bytes.get(bytes.position()) == PROOF_OF_A_ROBOT[0]) {
                            counters.received(1, 0);
                        }
                        guest.received(bytes);
                    }

                    @Override
                    public void closed() {
                        guest.closed();
                    }
                };
            }

            @Override
            public PeerMessageFormat speech() {
                return new PeerMessageFormat(text, LONGEST, LONGEST);
            }
        };
        return Endpoint.open(
                EndpointUrl.parse("wsserver://127.0.0.1:0"),
                handlers,
                EndpointSecurity.of(DtlsKeys.none()),
                new RealTime());
    }

    private static int opcode(boolean text) {
        return text ? WebSocketPeer.TEXT : WebSocketPeer.BINARY;
    }

    private static void awaitBytes(CountingPeerHandlers gathering, int bytes) {
        TestCloud.await(PATIENCE, () -> gathering.bytes() == bytes, () -> gathering.bytes() + " bytes came");
    }

    private static byte[] proof(boolean text) {
        return text ? PROOF_OF_A_ROBOT : new FrameWriter(1, 1, 1).frame(new Heartbeat(2, 12, 0, 0, 3, 3));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aStrangersMessageEndsAtAFewKilobytes(boolean text) throws IOException {
        CountingPeerHandlers gathering = new CountingPeerHandlers();
        try (Endpoint endpoint = open(gathering, text);
                WebSocketPeer stranger = new WebSocketPeer(endpoint.url().port())) {
            stranger.says(opcode(text), KILOBYTE);
            for (int piece = 1; piece < BoundedWebSocketDraft.STRANGERS_BYTES / KILOBYTE.length - 1; piece++) {
                stranger.says(WebSocketPeer.CONTINUED, KILOBYTE);
            }
            stranger.says(WebSocketPeer.CONTINUED | WebSocketPeer.LAST, KILOBYTE);
            awaitBytes(gathering, BoundedWebSocketDraft.STRANGERS_BYTES);

            stranger.says(opcode(text), KILOBYTE);
            for (int piece = 1; piece < BoundedWebSocketDraft.STRANGERS_BYTES / KILOBYTE.length; piece++) {
                stranger.says(WebSocketPeer.CONTINUED, KILOBYTE);
            }
            stranger.says(WebSocketPeer.CONTINUED, new byte[] {' '});
            assertThat(stranger.farewell()).isEqualTo(TOO_BIG);
            assertThat(gathering.bytes()).isEqualTo(BoundedWebSocketDraft.STRANGERS_BYTES);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aStrangerGetsNoRoomForWhatIsOnlyAnnounced(boolean text) throws IOException {
        try (Endpoint endpoint = open(new CountingPeerHandlers(), text);
                WebSocketPeer stranger = new WebSocketPeer(endpoint.url().port())) {
            stranger.says(opcode(text) | WebSocketPeer.LAST, BoundedWebSocketDraft.STRANGERS_BYTES + 1, new byte[0]);

            assertThat(stranger.farewell()).isEqualTo(TOO_BIG);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whoeverProvedToBeOneMaySayMore(boolean text) throws IOException {
        CountingPeerHandlers gathering = new CountingPeerHandlers();
        try (Endpoint endpoint = open(gathering, text);
                WebSocketPeer vehicle = new WebSocketPeer(endpoint.url().port())) {
            vehicle.says(opcode(text) | WebSocketPeer.LAST, proof(text));
            int before = proof(text).length;
            awaitBytes(gathering, before);
            vehicle.says(opcode(text), KILOBYTE);
            for (int piece = 1; piece < LONGEST / KILOBYTE.length - 1; piece++) {
                vehicle.says(WebSocketPeer.CONTINUED, KILOBYTE);
            }
            vehicle.says(WebSocketPeer.CONTINUED | WebSocketPeer.LAST, KILOBYTE);
            awaitBytes(gathering, before + LONGEST);

            vehicle.says(opcode(text), KILOBYTE);
            for (int piece = 1; piece < LONGEST / KILOBYTE.length; piece++) {
                vehicle.says(WebSocketPeer.CONTINUED, KILOBYTE);
            }
            vehicle.says(WebSocketPeer.CONTINUED, new byte[] {' '});
            assertThat(vehicle.farewell()).isEqualTo(TOO_BIG);
            assertThat(gathering.bytes()).isEqualTo(before + LONGEST);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void answersToPingsDoNotPileUpForWhoDoesNotReadThem(boolean text) throws IOException {
        CountingPeerHandlers gathering = new CountingPeerHandlers();
        try (Endpoint endpoint = open(gathering, text);
                WebSocketPeer stranger = new WebSocketPeer(endpoint.url().port())) {
            for (int count = 0; count < 100_000; count++) {
                stranger.saysShort(WebSocketPeer.PING | WebSocketPeer.LAST, blank(125));
            }
            stranger.says(opcode(text) | WebSocketPeer.LAST, KILOBYTE);
            awaitBytes(gathering, KILOBYTE.length);

            assertThat(endpoint.peers().get(0).queue()).isLessThanOrEqualTo(100);
        }
    }
}
