package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.drone.LinkState;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What a silence on a link means, by real time. */
class LinkSilenceTest {
    private static final int REQUEST_MESSAGE = 512;

    private final TestCloud cloud = new TestCloud(0);
    private final CapturingPeer hop = new CapturingPeer("udp", new PeerAddress("127.0.0.1", 15_900));
    private final PeerHandler way = cloud.opened(hop);
    private final FrameWriter writer = new FrameWriter(1, 1, 2);

    @AfterEach
    void close() {
        cloud.close();
    }

    private void says(Message message) {
        way.received(ByteBuffer.wrap(writer.frame(message)));
    }

    private List<LinkState> states() {
        return cloud.cloud().drones().stream()
                .map(drone -> drone.link().state())
                .toList();
    }

    private List<CommandLong> probes() {
        return hop.heard().stream()
                .filter(frame -> frame.messageId() == CommandLong.ID)
                .map(CommandLong::decode)
                .filter(asked -> asked.command() == REQUEST_MESSAGE && asked.param1() == Heartbeat.ID)
                .toList();
    }

    @Test
    void aVehicleThatSaysAnythingIsNotLost() throws InterruptedException {
        says(new Heartbeat(2, 3, 81, 4, 4, 3));
        cloud.awaitDrone(drone -> drone.link().state() == LinkState.LIVE);
        // Longer than the five seconds after which a silent one is lost.
        for (int i = 0; i < 70; i++) {
            says(new Attitude(i, 0f, 0f, 0f, 0f, 0f, 0f));
            TimeUnit.MILLISECONDS.sleep(100);
        }
        assertThat(states()).hasSize(1).doesNotContain(LinkState.LOST);
    }

    /** Vehicles go home after five seconds: more than a few may get lost on the way. */
    @Test
    void aVehicleHearsTheCloudTwiceASecond() {
        says(new Heartbeat(2, 3, 81, 4, 4, 3));
        cloud.awaitDrone(drone -> drone.link().state() == LinkState.LIVE);
        long before = beats();
        long began = System.nanoTime();
        TestCloud.await(Duration.ofSeconds(30), () -> beats() >= before + 9, () -> beats() + " heartbeats");
        assertThat(Duration.ofNanos(System.nanoTime() - began)).isLessThan(Duration.ofSeconds(7));
    }

    private long beats() {
        return hop.heard().stream()
                .filter(frame -> frame.messageId() == Heartbeat.ID)
                .count();
    }

    @Test
    void aVehicleIsAskedForASignOfLifeBeforeItIsLost() {
        says(new Heartbeat(2, 3, 81, 4, 4, 3));
        cloud.awaitDrone(drone -> drone.link().state() == LinkState.LIVE);
        TestCloud.await(Duration.ofSeconds(30), () -> states().contains(LinkState.LOST), () -> "it is " + states());
        assertThat(probes()).isNotEmpty();
    }
}
