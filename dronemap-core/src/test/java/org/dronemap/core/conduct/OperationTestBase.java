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
import org.dronemap.core.cloud.CloudFixtures;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.operation.JournalReplay;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** Operations of one kind with a drone whose vehicle keeps what it was told. */
abstract class OperationTestBase {
    static final OperationId ID = new OperationId("w1");
    static final CommandId FIRST = new CommandId("command-1");

    private final Lanes lanes = new Lanes(new RealTime(), 2);
    final StoreWriter journal = new StoreWriter(new RealTime());
    final CloudFixtures.InMemoryCommandStore commands = new CloudFixtures.InMemoryCommandStore();
    final CloudFixtures.InMemoryDroneStore drones = new CloudFixtures.InMemoryDroneStore();
    final CloudFixtures.InMemoryLeaseStore leases = new CloudFixtures.InMemoryLeaseStore();
    final CloudFixtures.InMemoryParameterOverrideStore owners = new CloudFixtures.InMemoryParameterOverrideStore();
    final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();
    final FailingOperationStore store = new FailingOperationStore();
    final AtomicInteger numbers = new AtomicInteger();
    final AtomicReference<Optional<String>> rights = new AtomicReference<>(Optional.empty());
    final List<String> told = new CopyOnWriteArrayList<>();
    CloudManager cloud = cloud();
    Operations operations = operations();
    DroneLink link;

    @BeforeEach
    void connect() {
        callIn(FlightPhase.ON_GROUND);
        operations.restore();
        operations.goOn();
    }

    /** The drone's vehicle is heard: what it is comes last, as from then on it is cared for. */
    void callIn(FlightPhase phase) {
        link = CloudFixtures.bound(cloud.admit(new Claim(
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle),
                CloudFixtures.copter(null),
                null,
                true,
                0)));
        hear(new DroneEvent.ModeReported("GUIDED", phase != FlightPhase.ON_GROUND));
        hear(new DroneEvent.PhaseReported(phase));
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), CloudFixtures.ALL));
    }

    @AfterEach
    void close() {
        ArmingOperation.TestComputation.mayEnd.countDown();
        ArmingOperation.poisonous = false;
        operations.close();
        lanes.close();
        journal.close();
    }

    CloudManager cloud() {
        return new CloudManager(
                lanes,
                Watchdog.DEFAULT,
                new RealTime(),
                new CloudManager.Persistence(drones, commands, leases, owners, journal),
                () -> new DroneId("drone-" + numbers.incrementAndGet()));
    }

    Operations operations() {
        Operations made = new Operations(
                cloud,
                store,
                (owner, drone) -> rights.get(),
                new SeparationBoard(),
                new RealTime(),
                List.of(ArmingOperation.KIND));
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

    ArmingOperation.State begin() {
        SavedOperation begun = SavedOperation.begun(
                ID,
                ArmingOperation.KIND.name(),
                new SavedOperation.Owner("ann", "ann", OrganisationId.HOME),
                "a watch",
                Instant.now());
        return operations
                .begin(ArmingOperation.KIND, begun, ArmingOperation.of(link.id()))
                .state();
    }

    ArmingOperation.State wish(String what) {
        return operations.request(ArmingOperation.KIND, ID, what).state();
    }

    List<String> heard() {
        return operations.find(ArmingOperation.KIND, ID).orElseThrow().state().heard();
    }

    boolean isHeldByIt(DroneId drone) {
        Lease tenure = cloud.controls().control(drone).tenure();
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
        operations.restore();
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
        JournalReplay<ArmingOperation.State, String> replay = new JournalReplay<>(ArmingOperation.KIND);
        replay.replay(store.journal(ID, 0, 1_000));
        assertThat(replay.difference()).isEmpty();
        assertThat(replay.count()).isEqualTo(store.journal.size());
    }
}
