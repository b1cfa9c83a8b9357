package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;

/** Whole sessions, from the socket's bytes to the drones' lanes, under hostile frames of many vehicles and addresses. */
final class SessionFuzz {
    private static final int PEERS = 24;
    private static final int SYSTEMS = 4;
    private static final int WARM_UP = 5_000;

    private final Random random;
    private final TestCloud cloud;
    private final HostileFrames hostile;
    private final List<PeerHandler> peers = new ArrayList<>();
    private final AtomicLong sent = new AtomicLong();

    /** Swallows what is sent. */
    private record DiscardingPeer(int port, AtomicLong sent) implements Peer {
        @Override
        public PeerAddress address() {
            return new PeerAddress(isLocal() ? "127.0.0.1" : "192.0.2.1", port);
        }

        @Override
        public String transport() {
            return "udp";
        }

        @Override
        public boolean isLocal() {
            return port % 2 == 0;
        }

        @Override
        public boolean isDatagram() {
            return true;
        }

        @Override
        public void send(byte[] frame) {
            sent.incrementAndGet();
        }
    }

    private SessionFuzz(Random random, TestCloud cloud) {
        this.random = random;
        this.cloud = cloud;
        hostile = new HostileFrames(random, SYSTEMS);
        for (int port = 1; port <= PEERS; port++) {
            peers.add(cloud.opened(new DiscardingPeer(port, sent)));
        }
    }

    static long run(FuzzBudget budget) {
        try (TestCloud cloud = new TestCloud(0)) {
            SessionFuzz fuzz = new SessionFuzz(budget.random(), cloud);
            long rounds = 0;
            for (; rounds < WARM_UP; rounds++) {
                fuzz.deliver(fuzz.bytes());
            }
            fuzz.settles();
            HeapGrowthCheck heap = new HeapGrowthCheck();
            while (budget.isLeft()) {
                byte[] bytes = fuzz.bytes();
                SlowInputCheck.check(budget.name(), bytes, () -> fuzz.deliver(bytes));
                rounds++;
            }
            fuzz.settles();
            assertThat(cloud.lanes().failedCount()).as(budget.name()).isZero();
            assertThat(cloud.cloud().drones())
                    .as(budget.name())
                    .isNotEmpty()
                    .hasSizeLessThanOrEqualTo(PEERS * SYSTEMS * 4);
            heap.check(budget.name());
            return rounds;
        }
    }

    private byte[] bytes() {
        if (random.nextInt(10) == 0) {
            int autopilot = List.of(3, 12, 0).get(random.nextInt(3));
            return new FrameWriter(1 + random.nextInt(SYSTEMS), 1, 2)
                    .frame(new Heartbeat(2, autopilot, 81, random.nextInt(30), 4, 3));
        }
        byte[] bytes = hostile.next();
        if (random.nextInt(8) == 0) {
            bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
        }
        return bytes;
    }

    private void deliver(byte[] bytes) {
        peers.get(random.nextInt(peers.size())).received(ByteBuffer.wrap(bytes));
    }

    /** Nothing waits any more, and no lane is stuck. */
    private void settles() {
        AtomicLong passed = new AtomicLong();
        cloud.lanes().all().forEach(lane -> lane.execute(passed::incrementAndGet));
        TestCloud.await(
                Duration.ofSeconds(30),
                () -> passed.get() == cloud.lanes().all().size(),
                () -> "a lane is stuck");
    }
}
