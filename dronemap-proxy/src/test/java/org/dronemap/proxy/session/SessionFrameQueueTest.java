package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class SessionFrameQueueTest {
    private final Lane lane = new Lane(new RealTime(), "mailbox-test", 64);
    private final CountDownLatch busy = new CountDownLatch(1);
    private final FrameWriter writer = new FrameWriter(1, 1, 2);
    private final List<Frame> taken = new CopyOnWriteArrayList<>();
    private final SessionFrameQueue mailbox = new SessionFrameQueue(lane, taken::add);

    @AfterEach
    void close() {
        busy.countDown();
        lane.close();
    }

    @Test
    void refusesWhatNewerNewsReplacesSoonerThanTheRestAndKeepsTheOrder() {
        lane.execute(this::standStill);
        List<Frame> kept = new ArrayList<>();
        for (int i = 0; i < 2_000; i++) {
            offer(CapturingPeer.frame(writer, new Attitude(i, 0f, 0f, 0f, 0f, 0f, 0f)), kept);
        }
        assertThat(kept).hasSize(768);
        for (int i = 0; i < 2_000; i++) {
            offer(CapturingPeer.frame(writer, new Heartbeat(2, 3, 81, i, 4, 3)), kept);
        }
        assertThat(kept).hasSize(1_024);
        assertThat(mailbox.waiting()).isEqualTo(1_024);

        busy.countDown();
        TestCloud.await(Duration.ofSeconds(30), () -> taken.size() >= kept.size(), () -> "only " + taken.size());
        assertThat(taken).containsExactlyElementsOf(kept);
        assertThat(mailbox.waiting()).isZero();
    }

    private void offer(Frame frame, List<Frame> kept) {
        if (mailbox.offer(frame)) {
            kept.add(frame);
        }
    }

    private void standStill() {
        try {
            busy.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
