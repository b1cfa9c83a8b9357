package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.Fixtures;
import org.dronemap.core.cloud.Journal;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.Watchdog;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.Tenure;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.Replay;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.time.SystemTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** Operations of one kind with a drone whose vehicle keeps what it was told. */
abstract class WatchHouse {
    static final OperationId ID = new OperationId("w1");
    static final CommandId FIRST = new CommandId("command-1");

    private final Lanes lanes = new Lanes(new SystemTime(), 2);
    final Journal journal = new Journal(new SystemTime());
    final Fixtures.HeapCommandStore commands = new Fixtures.HeapCommandStore();
    final Fixtures.HeapDroneStore drones = new Fixtures.HeapDroneStore();
    final Fixtures.HeapLeaseStore leases = new Fixtures.HeapLeaseStore();
    final Fixtures.HeapOwnersStore owners = new Fixtures.HeapOwnersStore();
    final Fixtures.RecordingChannel vehicle = new Fixtures.RecordingChannel();
    final HeapOperationStore store = new HeapOperationStore();
    final AtomicInteger numbers = new AtomicInteger();
    final AtomicReference<Optional<String>> rights = new AtomicReference<>(Optional.empty());
    final List<String> told = new CopyOnWriteArrayList<>();
    CloudManager cloud = cloud();
    Operations operations = operations();
    DroneLink link;

    @BeforeEach
    void connect() {
        callIn(FlightPhase.ON_GROUND);
        operations.takeUp();
        operations.goOn();
    }

    /** The drone's vehicle is heard: what it is comes last, as from then on it is cared for. */
    void callIn(FlightPhase phase) {
        link = Fixtures.bound(cloud.admit(new Claim(
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle),
                Fixtures.copter(null),
                null,
                true,
                0)));
        hear(new DroneEvent.ModeHeard("GUIDED", phase != FlightPhase.ON_GROUND));
        hear(new DroneEvent.PhaseHeard(phase));
        hear(new DroneEvent.Identified(Fixtures.copter(null), Fixtures.ALL));
    }

    @AfterEach
    void close() {
        Watch.Work.mayEnd.countDown();
        Watch.poisonous = false;
        operations.close();
        lanes.close();
        journal.close();
    }

    CloudManager cloud() {
        return new CloudManager(
                lanes,
                Watchdog.DEFAULT,
                new SystemTime(),
                new CloudManager.Keeping(drones, commands, leases, owners, journal),
                () -> new DroneId("drone-" + numbers.incrementAndGet()));
    }

    Operations operations() {
        Operations made =
                new Operations(cloud, store, (owner, drone) -> rights.get(), new SystemTime(), List.of(Watch.KIND));
        made.addListener((saved, why) -> told.add(why));
        return made;
    }

    void hear(DroneEvent event) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        link.lane().execute(() -> {
            link.accept(event);
            done.complete(null);
        });
        assertThat(done).succeedsWithin(5, TimeUnit.SECONDS);
    }

    Watch.State begin() {
        SavedOperation begun = SavedOperation.begun(
                ID,
                Watch.KIND.name(),
                new SavedOperation.Owner("ann", "ann", OrganisationId.HOME),
                "a watch",
                Instant.now());
        return operations.begin(Watch.KIND, begun, Watch.of(link.id())).state();
    }

    Watch.State wish(String what) {
        return operations.wish(Watch.KIND, ID, what).state();
    }

    List<String> heard() {
        return operations.find(Watch.KIND, ID).orElseThrow().state().heard();
    }

    boolean isHeldByIt(DroneId drone) {
        Tenure tenure = cloud.controls().control(drone).tenure();
        return tenure != null && tenure.holder().isOperation(ID.value());
    }

    void end(CommandId id, Outcome outcome) {
        await().until(() -> vehicle.reports.containsKey(id));
        vehicle.reports.get(id).ended(outcome);
    }

    /** What is left when the process dies, in a new one. */
    void restart() {
        restartDeaf();
        operations.goOn();
    }

    /** The new one does not let vehicles in yet. */
    void restartDeaf() {
        die();
        operations.takeUp();
    }

    /** The new one goes on with nothing of what was under way. */
    void restartWithout(String why) {
        die();
        operations.setAside(why);
        operations.goOn();
    }

    private void die() {
        operations.close();
        commands.records.replaceAll((id, record) -> record.outcome() == null
                ? record.ended(new Outcome.Unknown("The server restarted."), Instant.now())
                : record);
        cloud = cloud();
        operations = operations();
    }

    void assertReplays() {
        Replay<Watch.State, String> replay = new Replay<>(Watch.KIND);
        replay.take(store.journal(ID, 0, 1_000));
        assertThat(replay.difference()).isEmpty();
        assertThat(replay.count()).isEqualTo(store.journal.size());
    }
}
