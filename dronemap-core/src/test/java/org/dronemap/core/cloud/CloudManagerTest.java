package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.time.RealTime;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class CloudManagerTest {
    private static final Watchdog QUICK =
            new Watchdog(Duration.ofMillis(100), Duration.ofMillis(100), Duration.ofMillis(200));

    private final Lanes lanes = new Lanes(new RealTime(), 2);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final CloudFixtures.InMemoryDroneStore store = new CloudFixtures.InMemoryDroneStore();
    private final AtomicInteger numbers = new AtomicInteger();
    private final CloudManager cloud = manager();

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    @Test
    void keepsTwoVehiclesWithOneSystemIdApart() {
        DroneLink one = connect(5001, null);
        DroneLink other = connect(5002, null);

        assertThat(one.id()).isNotEqualTo(other.id());
        assertThat(cloud.drones()).hasSize(2);
    }

    @Test
    void knowsAVehicleAgainByItsAddress() {
        DroneLink first = connect(5001, null);

        assertThat(connect(5001, null).id()).isEqualTo(first.id());
    }

    @Test
    void takesAnotherBoardAtAnOldAddressForAnotherDrone() {
        DroneLink first = connect(5001, "aa01");

        assertThat(connect(5001, "bb02").id()).isNotEqualTo(first.id());
    }

    @Test
    void losesASilentDroneTellsItAndTakesItBack() {
        List<LinkState> seen = new CopyOnWriteArrayList<>();
        cloud.addListener(new CloudListener() {
            @Override
            public void droneChanged(DroneState state) {
                seen.add(state.link().state());
            }
        });
        DroneLink link = connect(5001, null);
        hear(link);
        awaitLink(link.id(), LinkState.LOST);
        hear(link);
        await().untilAsserted(() -> assertThat(seen)
                .containsSubsequence(LinkState.LIVE, LinkState.SUSPECT, LinkState.LOST, LinkState.LIVE));
    }

    @Test
    void showsThatADroneIsHeardAlsoWhenItBringsNoNews() {
        List<Instant> shown = new CopyOnWriteArrayList<>();
        cloud.addListener(new CloudListener() {
            @Override
            public void droneChanged(DroneState state) {
                if (state.link().lastHeard() != null) {
                    shown.add(state.link().lastHeard());
                }
            }
        });
        DroneLink link = connect(5001, null);
        hear(link);
        Instant news = lastHeard(link);

        keepAlive(link);

        await("those who look on are told")
                .until(() -> shown.get(shown.size() - 1).isAfter(news.plusSeconds(2)));
        assertThat(shown).as("but not of each sign of life").hasSizeLessThan(20);
    }

    private Instant lastHeard(DroneLink link) {
        return Objects.requireNonNull(
                cloud.drone(link.id()).orElseThrow().link().lastHeard());
    }

    @Test
    void remembersDronesOverARestart() {
        DroneLink link = connect(5001, "aa01");
        cloud.rename(link.id(), "Rescue 7");

        CloudManager restarted = manager();

        assertThat(restarted.drones()).singleElement().satisfies(drone -> {
            assertThat(drone.id()).isEqualTo(link.id());
            assertThat(drone.name()).isEqualTo("Rescue 7");
            assertThat(drone.link().state()).isEqualTo(LinkState.LOST);
            assertThat(drone.position()).isNull();
        });
    }

    @Test
    void forgetsOnlyADroneThatIsLost() {
        DroneLink link = connect(5001, null);
        hear(link);
        assertThat(cloud.forget(link.id())).contains("The drone is in contact; only a lost drone can be removed.");

        awaitLink(link.id(), LinkState.LOST);

        assertThat(cloud.forget(link.id())).isEmpty();
        assertThat(cloud.drones()).isEmpty();
        assertThat(goneOnLane(link)).isTrue();
    }

    @Test
    void callsARecordingEndedAndNotLostWhenItIsOver() {
        DroneLink link = CloudFixtures.bound(cloud.admit(new Claim(
                new LinkSession(
                        new DroneKey("replay", 1, 1),
                        "replay",
                        true,
                        "ArduCopter 1",
                        new CloudFixtures.RecordingChannel()),
                CloudFixtures.copter(null),
                null,
                true,
                0)));
        hear(link);

        onLane(link, link::replayEnded);
        hear(link);

        assertThat(cloud.drone(link.id()).orElseThrow().link().state())
                .as("also when its last frames come in after that")
                .isEqualTo(LinkState.ENDED);
        assertThat(cloud.forget(link.id())).isEmpty();
    }

    private CloudManager manager() {
        return new CloudManager(
                lanes,
                QUICK,
                new RealTime(),
                new CloudManager.Persistence(
                        store,
                        new CloudFixtures.InMemoryCommandStore(),
                        new CloudFixtures.InMemoryLeaseStore(),
                        new CloudFixtures.InMemoryParameterOverrideStore(),
                        journal),
                () -> new DroneId("drone-" + numbers.incrementAndGet()));
    }

    private DroneLink connect(int port, @Nullable String uid) {
        LinkSession session = new LinkSession(
                new DroneKey("127.0.0.1", port, 1), "udp", false, "ArduCopter 1", new CloudFixtures.RecordingChannel());
        DroneLink link = CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(uid), null, true, 0)));
        onLane(link, () -> {});
        return link;
    }

    private static void hear(DroneLink link) {
        onLane(link, () -> link.accept(new DroneEvent.ModeReported("GUIDED", false)));
    }

    private static void keepAlive(DroneLink link) {
        onLane(link, () -> link.lane().addTimedTask(link::received));
    }

    private static boolean goneOnLane(DroneLink link) {
        CompletableFuture<Boolean> gone = new CompletableFuture<>();
        onLane(link, () -> gone.complete(link.isGone()));
        return gone.join();
    }

    private static void onLane(DroneLink link, Runnable work) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        link.lane().execute(() -> {
            work.run();
            done.complete(null);
        });
        assertThat(done).succeedsWithin(5, TimeUnit.SECONDS);
    }

    private void awaitLink(DroneId id, LinkState state) {
        await().until(() -> cloud.drone(id).orElseThrow().link().state() == state);
    }
}
