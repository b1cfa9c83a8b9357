package org.dronemap.core.history;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class TelemetryWriterTest {
    private static final TelemetryWriter.BatchSettings QUICK =
            new TelemetryWriter.BatchSettings(Duration.ofMillis(10), 50, 100, Duration.ofMillis(10));

    private final FailingTelemetryStore store = new FailingTelemetryStore();
    private final TelemetryWriter writer = new TelemetryWriter(store, QUICK, new RealTime());
    private final StateScript script = new StateScript();

    @AfterEach
    void close() {
        store.disk.countDown();
        writer.close();
    }

    @Test
    void writesWhatComesInBatchesOfABoundedSize() {
        bring(100);
        writer.start();

        await().atMost(Duration.ofSeconds(30)).until(() -> store.points.size() == 100);
        assertThat(store.batches).allMatch(size -> size <= 50);
        await().atMost(Duration.ofSeconds(30)).until(() -> writer.health().waiting() == 0);
        assertThat(writer.health()).isEqualTo(new HistoryHealth(null, 100, 0, 0));
    }

    @Test
    void dropsAndCountsWhatFindsNoRoomAndNeverWaits() {
        bring(130);

        HistoryHealth health = writer.health();
        assertThat(health.dropped()).isEqualTo(30);
        assertThat(health.waiting()).isEqualTo(100);
        assertThat(health.isUp()).isFalse();
        assertThat(health.trouble()).contains("too slow");
    }

    @Test
    void keepsRoomForEventsWhenPointsFillTheirs() {
        bring(130);
        writer.event(HistoryEvent.of(StateScript.DRONE, StateScript.START, HistoryEvent.Kind.MODE, "AUTO"));
        writer.start();

        await().atMost(Duration.ofSeconds(30)).until(() -> store.events.size() == 1);
        assertThat(writer.health().dropped()).isEqualTo(30);
    }

    @Test
    void saysSoWhileTheStoreIsAwayAndRecoversWithWhatIsInMemory() {
        store.broken = true;
        writer.start();
        bring(20);
        await().atMost(Duration.ofSeconds(30)).until(() -> !writer.health().isUp());
        assertThat(writer.health().trouble()).contains("the disk is full");

        store.broken = false;

        await().atMost(Duration.ofSeconds(30)).until(() -> store.points.size() == 20);
        await().atMost(Duration.ofSeconds(30)).until(() -> writer.health().isUp());
        assertThat(writer.health().dropped()).isZero();
    }

    @Test
    void givesUpWhatTheStoreNeverTakesAndGoesOn() {
        store.poison = "poison";
        writer.event(HistoryEvent.of(StateScript.DRONE, StateScript.START, HistoryEvent.Kind.MODE, "poison"));
        writer.start();
        await().atMost(Duration.ofSeconds(30)).until(() -> writer.health().dropped() == 1);
        bring(5);

        await().atMost(Duration.ofSeconds(30)).until(() -> store.points.size() == 5);
    }

    @Test
    void doesNotGiveUpWhatWasTriedJustBeforeTheStoreCameBack() {
        store.broken = true;
        store.backWhenAsked = true;
        writer.start();
        bring(20);

        await().atMost(Duration.ofSeconds(30)).until(() -> store.points.size() == 20);
        assertThat(writer.health().dropped()).isZero();
    }

    @Test
    void writesWhatWaitsWhenItIsClosed() {
        store.disk = new CountDownLatch(1);
        writer.start();
        bring(30);
        store.disk.countDown();

        writer.close();

        assertThat(store.points).hasSize(30);
    }

    @Test
    void tellsTheStoreWhatFoundNoRoom() {
        for (int second = 0; second < 103; second++) {
            writer.event(mode(second, "AUTO"));
        }
        writer.start();

        await().atMost(Duration.ofSeconds(30)).until(() -> store.events.size() == 100);
        assertThat(store.losses)
                .containsExactly(
                        new EventLoss(StateScript.START.plusSeconds(100), StateScript.START.plusSeconds(102), 3));
    }

    @Test
    void tellsTheStoreWhatItNeverTook() {
        store.poison = "poison";
        writer.event(mode(1, "AUTO"));
        writer.event(mode(2, "poison"));
        writer.start();

        await().atMost(Duration.ofSeconds(30)).until(() -> !store.losses.isEmpty());
        assertThat(store.losses)
                .containsExactly(new EventLoss(StateScript.START.plusSeconds(1), StateScript.START.plusSeconds(2), 2));
    }

    @Test
    void saysThatAllIsStoredOnlyWhenItIs() {
        writer.event(mode(1, "AUTO"));
        writer.start();
        await().atMost(Duration.ofSeconds(30)).until(() -> store.open);

        writer.close();

        assertThat(store.events).hasSize(1);
        assertThat(store.openedBefore).isFalse();
        assertThat(store.open).isFalse();
    }

    @Test
    void leavesTheMarkWhenItEndsWithEventsThatTheStoreDidNotTake() {
        writer.start();
        await().atMost(Duration.ofSeconds(30)).until(() -> store.open);
        store.broken = true;
        writer.event(mode(1, "AUTO"));

        writer.close();

        assertThat(store.events).isEmpty();
        assertThat(store.open).isTrue();
    }

    @Test
    void tellsListenersOnceEventsAreStored() {
        AtomicInteger stored = new AtomicInteger(-1);
        writer.onEventsStored(() -> stored.set(store.events.size()));
        writer.start();
        await().atMost(Duration.ofSeconds(30)).until(() -> stored.get() == 0);
        writer.event(mode(1, "AUTO"));

        await().atMost(Duration.ofSeconds(30)).until(() -> stored.get() == 1);
        assertThat(store.open).isTrue();
    }

    private static HistoryEvent mode(long second, String text) {
        return HistoryEvent.of(StateScript.DRONE, StateScript.START.plusSeconds(second), HistoryEvent.Kind.MODE, text);
    }

    private void bring(int points) {
        for (int i = 0; i < points; i++) {
            writer.point(TelemetryPoint.of(script.after(1).north(i, 1).state()));
        }
    }
}
