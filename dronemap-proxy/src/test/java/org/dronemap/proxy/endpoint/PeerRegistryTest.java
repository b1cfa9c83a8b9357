package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Who gets a place, who loses it, and what one peer may cost the others. */
class PeerRegistryTest {
    private static final long SECOND = 1_000_000_000L;
    private static final EndpointPeer.Origin PLACE = new EndpointPeer.Origin("udp", true, true, Optional.empty());

    private final SteppedTime time = new SteppedTime(Instant.EPOCH);
    private final EndpointCounters counters = new EndpointCounters();
    private final CountingPeerHandlers gathering = new CountingPeerHandlers();
    private final PeerRegistry<String> book =
            new PeerRegistry<>(counters, gathering, new PeerRegistry.Limits(6, 4), time);
    private final long start = time.nanos() + 100 * SECOND;
    private final FrameWriter writer = new FrameWriter(1, 1, 2);

    private @Nullable EndpointPeer add(String host, int port, long now) {
        return book.add(
                host + port,
                host,
                now,
                welcome -> new EndpointPeer(PLACE, new PeerAddress(host, port), f -> true, welcome));
    }

    private EndpointPeer seat(String host, int port, long now) {
        EndpointPeer seat = add(host, port, now);
        assertThat(seat).isNotNull();
        return seat;
    }

    private ByteBuffer heartbeat() {
        return ByteBuffer.wrap(writer.frame(new Heartbeat(0, 2, 3, 0, 81, 3)));
    }

    /** Bytes that look like the beginnings of frames and are none. */
    private static ByteBuffer broken() {
        byte[] bytes = new byte[280];
        Arrays.fill(bytes, (byte) 0xFD);
        return ByteBuffer.wrap(bytes);
    }

    /** As a WebSocket does, whose thread tells that the peer is gone while another one closes it. */
    private final class Reporting implements FrameSender {
        private final CompletableFuture<Void> told = new CompletableFuture<>();

        @Override
        public boolean send(byte[] frame) {
            return true;
        }

        @Override
        public void close() {
            CompletableFuture<Void> report = CompletableFuture.runAsync(() -> book.remove("gone"));
            try {
                report.get(10, TimeUnit.SECONDS);
                told.complete(null);
            } catch (InterruptedException | ExecutionException | TimeoutException e) {
                told.completeExceptionally(e);
            }
        }
    }

    @Test
    void keepsNobodyWaitingWhileItEndsAPeer() {
        List<Runnable> endings = List.of(
                book::clear,
                () -> book.remove("key"),
                () -> book.removeAllOf("host"),
                () -> book.sweep(start + 61 * SECOND));
        for (Runnable ending : endings) {
            Reporting wire = new Reporting();
            book.add(
                    "key",
                    "host",
                    start,
                    welcome -> new EndpointPeer(PLACE, new PeerAddress("host", 1), wire, welcome));

            ending.run();

            assertThat(wire.told).isCompleted();
            assertThat(counters.counts().peers()).isZero();
        }
    }

    @Test
    void oneHostCannotTakeEveryPlace() {
        for (int port = 0; port < 4; port++) {
            seat("flooder", port, start);
        }

        assertThat(add("flooder", 5, start)).isNull();
        assertThat(counters.counts().refusedPeers()).isEqualTo(1);
        seat("other", 1, start);
        assertThat(counters.counts().peers()).isEqualTo(5);
    }

    @Test
    void silentStrangersMakeRoomBeforeVehiclesDo() {
        EndpointPeer vehicle = seat("host", 1, start);
        vehicle.received(heartbeat(), start);
        for (int port = 2; port < 5; port++) {
            seat("host", port, start);
        }

        assertThat(add("host", 9, start + 5 * SECOND)).isNull();
        seat("host", 9, start + 11 * SECOND);

        assertThat(book.find("host1")).isSameAs(vehicle);
        assertThat(book.find("host2")).isNull();
        assertThat(gathering.guests().get(1).isClosed()).isTrue();
    }

    @Test
    void aVehicleThatIsSilentForAMinuteLosesItsPlace() {
        EndpointPeer vehicle = seat("host", 1, start);
        vehicle.received(heartbeat(), start);

        book.sweep(start + 59 * SECOND);
        assertThat(book.find("host1")).isSameAs(vehicle);
        book.sweep(start + 61 * SECOND);
        assertThat(book.find("host1")).isNull();
        assertThat(counters.counts().peers()).isZero();
    }

    @Test
    void aFloodOfBrokenBytesIsHardlyReadAndCounted() {
        EndpointPeer flooder = seat("host", 1, start);
        int datagrams = 50_000;
        for (int count = 0; count < datagrams; count++) {
            flooder.received(broken(), start + count * SECOND / datagrams);
        }

        long read = gathering.guests().get(0).bytes() / 280;
        assertThat(read).isBetween(1L, 100L);
        assertThat(counters.counts().throttled()).isEqualTo(datagrams - read);
    }

    @Test
    void aVehicleBehindTheFloodersAddressIsReadWhileTheFloodLasts() {
        EndpointPeer flooder = seat("host", 1, start);
        EndpointPeer vehicle = seat("host", 2, start);
        vehicle.received(heartbeat(), start);
        for (int count = 0; count < 50_000; count++) {
            long now = start + count * SECOND / 50_000;
            flooder.received(broken(), now);
            if (count % 1_000 == 0) {
                vehicle.received(heartbeat(), now);
            }
        }
        EndpointPeer newcomer = seat("host", 3, start + SECOND);
        newcomer.received(heartbeat(), start + SECOND);

        assertThat(gathering.guests().get(1).frames()).isEqualTo(51);
        assertThat(gathering.guests().get(2).frames()).isEqualTo(1);
    }

    @Test
    void aFloodOfGoodFramesIsCutAboveWhatVehiclesSendAndMostWhenItBreaksLoose() {
        EndpointPeer vehicle = seat("host", 1, start);
        int inTheFirstSecond = 0;
        for (int second = 0; second < 10; second++) {
            for (int count = 0; count < 50_000; count++) {
                vehicle.received(heartbeat(), start + second * SECOND + count * SECOND / 50_000);
            }
            inTheFirstSecond = second == 0 ? gathering.guests().get(0).frames() : inTheFirstSecond;
        }

        assertThat(inTheFirstSecond).isBetween(1_000, 4_000);
        assertThat(gathering.guests().get(0).frames()).isBetween(80_000, 125_000);
    }

    @Test
    void aVehicleAtAThousandMessagesASecondIsNeverCut() {
        EndpointPeer vehicle = seat("host", 1, start);
        for (int count = 0; count < 10_000; count++) {
            vehicle.received(heartbeat(), start + count * SECOND / 1_000);
        }

        assertThat(gathering.guests().get(0).frames()).isEqualTo(10_000);
        assertThat(counters.counts().throttled()).isZero();
    }

    @Test
    void theLongestSilentLinkOfAnIdentityGivesWayToANewOne() {
        for (int port = 0; port < 4; port++) {
            seat("vehicle", port, start + port);
        }

        book.makeRoomFor("vehicle");
        seat("vehicle", 9, start + 10);

        assertThat(book.find("vehicle0")).isNull();
        assertThat(book.find("vehicle1")).isNotNull();
        book.removeAllOf("vehicle");
        assertThat(counters.counts().peers()).isZero();
    }
}
