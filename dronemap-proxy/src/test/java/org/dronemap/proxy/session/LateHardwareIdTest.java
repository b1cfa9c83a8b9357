package org.dronemap.proxy.session;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What a vehicle says of its hardware only after it was taken for a drone. */
class LateHardwareIdTest {
    private final TestCloud cloud = new TestCloud(0);
    private final PeerHandler way = cloud.opened(new CapturingPeer("udp", new PeerAddress("127.0.0.1", 15_910)));
    private final FrameWriter writer = new FrameWriter(1, 1, 2);

    @AfterEach
    void close() {
        cloud.close();
    }

    private void says(Message message) {
        way.received(ByteBuffer.wrap(writer.frame(message)));
    }

    private void isBoard(long uid) {
        says(new AutopilotVersion(0, 0, 0, 0, 0, new int[8], new int[8], new int[8], 0, 0, uid, new int[18]));
        says(new Heartbeat(2, 3, 81, 4, 4, 3));
    }

    private void awaitBoards(String... wanted) {
        TestCloud.await(
                Duration.ofSeconds(30),
                () -> boards().equals(List.of(wanted)),
                () -> "boards " + boards() + " instead of " + List.of(wanted));
    }

    private List<String> boards() {
        return cloud.cloud().drones().stream()
                .map(drone -> String.valueOf(drone.identification().hardwareUid()))
                .sorted()
                .toList();
    }

    @Test
    void anotherBoardAtTheSameAddressIsAnotherDrone() {
        says(new Heartbeat(2, 3, 81, 4, 4, 3));
        awaitBoards("null");
        isBoard(0xa1);
        awaitBoards("a1");
        isBoard(0xb2);
        awaitBoards("a1", "b2");
    }
}
