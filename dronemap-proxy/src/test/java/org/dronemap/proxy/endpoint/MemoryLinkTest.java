package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;

/** A peer without a socket is treated as one at a door for datagrams. */
class MemoryLinkTest {
    private static final PeerAddress ADDRESS = new PeerAddress("127.0.0.1", 14_551);

    private final SteppedTime time = new SteppedTime(Instant.EPOCH);
    private final CountingPeerHandlers gathering = new CountingPeerHandlers();
    private final List<byte[]> told = new ArrayList<>();
    private final FrameWriter writer = new FrameWriter(1, 1, 2);
    private final MemoryLink link = new MemoryLink(gathering, ADDRESS, told::add, time);

    private byte[] heartbeat() {
        return writer.frame(new Heartbeat(0, 2, 3, 0, 81, 3));
    }

    @Test
    void carriesAndCountsBothWays() {
        assertThat(link.peers()).isEmpty();

        link.received(heartbeat());
        link.received(heartbeat());

        assertThat(gathering.guests()).hasSize(1);
        CountingPeerHandlers.CountingPeer guest = gathering.guests().get(0);
        assertThat(guest.frames()).isEqualTo(2);
        assertThat(guest.peer().address()).isEqualTo(ADDRESS);
        assertThat(guest.peer().transport()).isEqualTo("udp");
        assertThat(guest.peer().isDatagram()).isTrue();
        assertThat(guest.peer().isLocal()).isTrue();
        assertThat(told).hasSize(2).allMatch(frame -> frame.length == 1);
        assertThat(link.counts())
                .returns(1, EndpointCounters.Counts::peers)
                .returns(2L, EndpointCounters.Counts::framesIn)
                .returns(2L, EndpointCounters.Counts::framesOut);
    }

    @Test
    void dropsAndCountsWhatIsTooMuchUntilTimeHasGoneBy() {
        byte[] broken = new byte[5_000];
        for (int count = 0; count < 10; count++) {
            link.received(broken);
        }

        int taken = gathering.bytes();
        assertThat(taken).isLessThan(50_000);
        assertThat(link.counts().throttled()).isEqualTo(10 - taken / 5_000);

        time.advance(Duration.ofSeconds(11));
        link.received(broken);
        assertThat(gathering.bytes()).isEqualTo(taken + 5_000);
    }

    @Test
    void carriesNothingAfterItsClose() {
        link.received(heartbeat());
        CountingPeerHandlers.CountingPeer guest = gathering.guests().get(0);
        link.close();

        assertThat(guest.isClosed()).isTrue();
        link.received(heartbeat());
        guest.peer().send(new byte[] {2});
        assertThat(guest.frames()).isEqualTo(1);
        assertThat(told).hasSize(1);
        assertThat(link.counts())
                .returns(0, EndpointCounters.Counts::peers)
                .returns(1L, EndpointCounters.Counts::droppedOut);
    }
}
