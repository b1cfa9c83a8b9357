package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.OutdatedPart;
import org.dronemap.core.drone.StatePart;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HighLatency2;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A vehicle that goes over to a link on which it says all in one message, without heartbeats. */
class SatelliteLinkTest {
    private final SteppedTime time = new SteppedTime(Instant.parse("2026-04-05T06:07:08Z"));
    private final TestCloud cloud = new TestCloud(componentId -> FrameTap.NONE, time);
    private final CapturingPeer peer = new CapturingPeer("udp", new PeerAddress("127.0.0.1", 15_931));
    private final PeerHandler way = cloud.opened(peer);
    private final FrameWriter writer = new FrameWriter(44, 1, 2);

    @AfterEach
    void close() {
        cloud.close();
        assertThat(time.failures()).isEmpty();
    }

    private void says(Message message) {
        way.received(ByteBuffer.wrap(writer.frame(message)));
    }

    private void summaries(int seconds) {
        for (int second = 0; second < seconds; second += 2) {
            summary();
            time.advance(Duration.ofSeconds(2));
        }
    }

    private void summary() {
        says(new HighLatency2(
                0,
                2,
                12,
                5 << 8 | 4,
                471_000_000,
                81_000_000,
                540,
                540,
                45,
                45,
                0,
                0,
                10,
                10,
                10,
                0,
                0,
                0,
                0,
                0,
                0,
                66,
                2,
                0,
                0,
                0,
                0));
    }

    /** Once a second: how it stands with the link, and what is old. */
    private Set<String> states(int seconds) {
        Set<String> seen = new LinkedHashSet<>();
        for (int second = 0; second < seconds; second++) {
            time.advance(Duration.ofSeconds(1));
            seen.add(drone().link().state() + " " + drone().link().outdated());
        }
        return seen;
    }

    @ParameterizedTest
    @ValueSource(ints = {5, 10, 60})
    void oneThatSpeaksSeldomIsNeitherLostNorOldInBetween(int interval) {
        summary();
        time.advance(Duration.ofSeconds(2));
        Set<String> seen = new LinkedHashSet<>();
        for (int i = 0; i < 6; i++) {
            seen.addAll(states(interval));
            summary();
        }
        assertThat(seen).containsExactly("LIVE []");

        assertThat(states(4 * interval + 5)).anyMatch(state -> state.startsWith("LOST"));
    }

    @Test
    void oneThatSpeaksAllTheTimeAgainIsLostAsSoonAsAnyOther() {
        for (int i = 0; i < 3; i++) {
            summary();
            time.advance(Duration.ofSeconds(60));
        }
        says(new Heartbeat(2, 12, 209, 4L << 16 | 4L << 24, 4, 3));
        time.advance(Duration.ofSeconds(6));

        assertThat(drone().link().state()).isEqualTo(LinkState.LOST);
    }

    @Test
    void oneThatSpeaksAllTheTimeIsLostAsSoonAsAnyOtherThoughItSaysAllInOneMessageToo() {
        for (int i = 0; i < 20; i++) {
            says(new Heartbeat(2, 12, 209, 4L << 16 | 4L << 24, 4, 3));
            time.advance(Duration.ofMillis(500));
            summary();
            time.advance(Duration.ofMillis(500));
        }
        assertThat(drone().link().state()).isEqualTo(LinkState.LIVE);
        time.advance(Duration.ofSeconds(6));

        assertThat(drone().link().state()).isEqualTo(LinkState.LOST);
    }

    @Test
    void aSummaryThatComesTwiceChangesNoRhythm() {
        for (int i = 0; i < 4; i++) {
            time.advance(Duration.ofSeconds(60));
            summary();
            summary();
        }
        assertThat(states(55)).containsExactly("LIVE []");
    }

    private DroneState drone() {
        assertThat(cloud.cloud().drones()).hasSize(1);
        return cloud.cloud().drones().get(0);
    }

    @Test
    void movesAndWhatItDoesNotTellAnyMoreIsToldAsOld() {
        says(new Heartbeat(2, 12, 209, 4L << 16 | 4L << 24, 4, 3));
        says(new Attitude(0, 0f, 0f, 0f, 0f, 0f, 0f));
        time.advance(Duration.ofSeconds(2));
        assertThat(drone().link().outdated()).isEmpty();

        summaries(14);

        assertThat(drone().link().state()).isNotEqualTo(LinkState.LOST);
        assertThat(drone().mode()).isEqualTo("RTL");
        assertThat(drone().position().altitudeAmslMeters()).isEqualTo(540);
        assertThat(drone().battery().percent()).isEqualTo(66);
        assertThat(drone().link().outdated())
                .extracting(OutdatedPart::part)
                .isEqualTo(List.of(StatePart.ARMED, StatePart.ATTITUDE));

        time.advance(Duration.ofSeconds(20));
        assertThat(drone().link().state()).isEqualTo(LinkState.LOST);
        assertThat(drone().link().outdated()).isEmpty();
    }

    @Test
    void isADroneThoughNoHeartbeatIsEverHeard() {
        summaries(6);
        assertThat(drone().identification().vehicle()).isEqualTo("PX4 copter");
        assertThat(drone().mode()).isEqualTo("RTL");
    }
}
