package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Clock;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.Fixtures;
import org.dronemap.core.cloud.Journal;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.Watchdog;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.Tenure;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.Replay;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class OperationsTest {
    private static final OperationId ID = new OperationId("w1");
    private static final CommandId FIRST = new CommandId("command-1");

    private final Lanes lanes = new Lanes(2);
    private final Journal journal = new Journal();
    private final Fixtures.HeapCommandStore commands = new Fixtures.HeapCommandStore();
    private final Fixtures.HeapDroneStore drones = new Fixtures.HeapDroneStore();
    private final Fixtures.HeapLeaseStore leases = new Fixtures.HeapLeaseStore();
    private final Fixtures.RecordingChannel vehicle = new Fixtures.RecordingChannel();
    private final HeapOperationStore store = new HeapOperationStore();
    private final AtomicInteger numbers = new AtomicInteger();
    private final AtomicReference<Optional<String>> rights = new AtomicReference<>(Optional.empty());
    private final List<String> told = new CopyOnWriteArrayList<>();
    private CloudManager cloud = cloud();
    private Operations operations = operations();
    private DroneLink link;

    @BeforeEach
    void connect() {
        link = Fixtures.bound(cloud.admit(new Claim(
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle),
                Fixtures.copter(null),
                null,
                true,
                0)));
        hear(new DroneEvent.Identified(Fixtures.copter(null), Fixtures.ALL));
        hear(new DroneEvent.ModeHeard("GUIDED", false));
        operations.start();
    }

    @AfterEach
    void close() {
        Watch.Work.mayEnd.countDown();
        operations.close();
        lanes.close();
        journal.close();
    }

    private CloudManager cloud() {
        return new CloudManager(
                lanes,
                Watchdog.DEFAULT,
                Clock.systemUTC(),
                new CloudManager.Keeping(drones, commands, leases, journal),
                () -> new DroneId("drone-" + numbers.incrementAndGet()));
    }

    private Operations operations() {
        Operations made =
                new Operations(cloud, store, (owner, drone) -> rights.get(), Clock.systemUTC(), List.of(Watch.KIND));
        made.addListener((saved, why) -> told.add(why));
        return made;
    }

    private void hear(DroneEvent event) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        link.lane().execute(() -> {
            link.accept(event);
            done.complete(null);
        });
        assertThat(done).succeedsWithin(5, TimeUnit.SECONDS);
    }

    private Watch.State begin() {
        SavedOperation begun = SavedOperation.begun(
                ID, Watch.KIND.name(), new SavedOperation.Owner("ann", OrganisationId.HOME), "a watch", Instant.now());
        return operations.begin(Watch.KIND, begun, Watch.of(link.id())).state();
    }

    private Watch.State wish(String what) {
        return operations.wish(Watch.KIND, ID, what).state();
    }

    private List<String> heard() {
        return operations.find(Watch.KIND, ID).orElseThrow().state().heard();
    }

    private boolean isHeldByIt(DroneId drone) {
        Tenure tenure = cloud.controls().control(drone).tenure();
        return tenure != null && tenure.holder().isOperation(ID.value());
    }

    private void end(CommandId id, Outcome outcome) {
        await().until(() -> vehicle.reports.containsKey(id));
        vehicle.reports.get(id).ended(outcome);
    }

    /** What is left when the process dies, in a new one. */
    private void restart() {
        operations.close();
        commands.records.replaceAll((id, record) -> record.outcome() == null
                ? record.ended(new Outcome.Unknown("The server restarted."), Instant.now())
                : record);
        cloud = cloud();
        operations = operations();
        operations.start();
    }

    private void assertReplays() {
        Replay<Watch.State, String> replay = new Replay<>(Watch.KIND);
        replay.take(store.journal(ID, 0, 1_000));
        assertThat(replay.difference()).isEmpty();
        assertThat(replay.count()).isEqualTo(store.journal.size());
    }

    @Test
    void commandsUnderItsOwnControlAsWhoeverStartedIt() {
        begin();
        assertThat(isHeldByIt(link.id())).isTrue();

        wish("arm");
        end(FIRST, new Outcome.Succeeded());

        await().until(() -> heard().contains("ended command-1 Succeeded"));
        CommandRecord record = commands.records.get(FIRST);
        assertThat(record.by()).isEqualTo("ann");
        assertThat(record.face()).isEqualTo("operation");
        assertThat(told).contains("It heard ended command-1 Succeeded");
        assertReplays();
    }

    @Test
    void writesADecisionDownBeforeItsCommandsGoOut() {
        begin();
        store.away = true;

        assertThatThrownBy(() -> wish("arm")).hasMessage("the disk is full");

        assertThat(vehicle.performed).isEmpty();
        assertThat(commands.records).isEmpty();
        store.away = false;
        wish("arm");
        await().until(() -> vehicle.performed.size() == 1);
        assertThat(store.operations.get(ID).given()).containsExactly(new SavedOperation.Given(link.id(), FIRST));
    }

    @Test
    void writesNothingDownOfWhatChangesNothing() {
        begin();
        wish("nothing");
        wish("note something");

        assertThat(store.journal).extracting(JournalEntry::input).containsExactly("drone-1||0|false", "note something");
    }

    @Test
    void losesNoEndOfACommandWhileTheStoreIsAwayAndSaysThatItIs() {
        begin();
        wish("arm");
        await().until(() -> vehicle.reports.containsKey(FIRST));
        store.away = true;

        end(FIRST, new Outcome.Failed("no"));

        await().until(() -> !operations.troubles().isEmpty());
        assertThat(operations.troubles()).containsExactly("“a watch” does not go on: the disk is full");
        assertThat(operations.failedCount()).isPositive();
        assertThat(heard()).isEmpty();
        store.away = false;
        await().until(() -> heard().equals(List.of("ended command-1 Failed")));
        await().until(() -> operations.troubles().isEmpty());
        assertReplays();
    }

    @Test
    void goesOnFromWhatIsStoredWhenAWriteOnlySeemedToFail() {
        begin();
        store.deceiving = true;

        assertThatThrownBy(() -> wish("arm")).hasMessage("the connection broke");

        await().until(() -> heard().contains("ended command-1 Refused"));
        assertThat(heard()).containsExactly("resumed", "ended command-1 Refused");
        assertThat(vehicle.performed).isEmpty();
        assertReplays();
    }

    @Test
    void beginsNothingThatCannotBeWrittenDown() {
        store.deceiving = true;

        assertThatThrownBy(this::begin).hasMessage("the connection broke");

        assertThat(isHeldByIt(link.id())).isFalse();
        assertThat(operations.underWay(Watch.KIND)).isEmpty();
        await().until(() -> store.operations.isEmpty());
    }

    @Test
    void isTakenUpAfterARestartBeforeAnybodyElseCanCommand() {
        begin();
        wish("arm");
        await().until(() -> vehicle.performed.size() == 1);

        restart();

        assertThat(isHeldByIt(link.id())).isTrue();
        CommandRecord refused = cloud.gate()
                .submit(
                        new CommandGate.Source(new Principal("bob", Role.OPERATOR), "rest"),
                        link.id(),
                        new CommandId("bobs-command"),
                        new Command.Arm());
        assertThat(refused.outcome()).isInstanceOf(Outcome.Refused.class);
        await().until(() -> heard().size() == 2);
        assertThat(heard()).containsExactly("resumed", "ended command-1 Unknown");
        assertReplays();
    }

    @Test
    void tellsOfCommandsThatWereWrittenDownAndNeverSent() {
        begin();
        commands.broken = true;
        wish("arm");
        // Whether it was sent is known as soon as that can be looked up.
        commands.broken = false;

        await().until(() -> heard().contains("ended command-1 Refused"));
        assertThat(vehicle.performed).isEmpty();
    }

    @Test
    void seesWhoTookADroneAndGivesUpItsControl() {
        begin();

        cloud.controls().apply(link.id(), new LeaseEvent.TakeOver("bob", "look out"));

        await().until(() -> heard().stream().anyMatch(one -> one.startsWith("taken bob has had control of it")));
        assertThat(operations.find(Watch.KIND, ID).orElseThrow().state().drones())
                .isEmpty();
        assertThat(cloud.controls().control(link.id()).isHeldBy("bob")).isTrue();
    }

    @Test
    void doesNotTakeBackADroneThatBecomesFreeAgain() {
        begin();
        cloud.controls().apply(link.id(), new LeaseEvent.PilotActed("LOITER"));
        cloud.controls().apply(link.id(), new LeaseEvent.PilotLeft());
        // What is decided meanwhile must not ask for it again.
        wish("note something");

        await().until(() -> heard().stream().anyMatch(one -> one.startsWith("taken")));

        assertThat(isHeldByIt(link.id())).isFalse();
    }

    @Test
    void letsGoOfADroneThatASupervisorBringsDown() {
        begin();
        hear(new DroneEvent.ModeHeard("GUIDED", true));
        hear(new DroneEvent.PhaseHeard(FlightPhase.IN_AIR));

        cloud.gate()
                .submit(
                        new CommandGate.Source(new Principal("sue", Role.SUPERVISOR), "rest"),
                        link.id(),
                        new CommandId("sue-lands-it"),
                        new Command.Land());

        await().until(() -> heard().contains("taken sue told the drone: land."));
        assertThat(isHeldByIt(link.id())).isFalse();
    }

    @Test
    void losesDronesThatItsOwnerMayNoLongerCommand() {
        begin();
        rights.set(Optional.of("ann may not command it any more."));

        await().until(() -> heard().contains("taken ann may not command it any more."));
    }

    @Test
    void doesNotBeginWithADroneThatSomebodyHas() {
        cloud.controls().apply(link.id(), new LeaseEvent.Take("bob"));

        assertThatThrownBy(this::begin)
                .isInstanceOfSatisfying(
                        Operations.Refused.class,
                        refused -> assertThat(refused.why()).contains("drone-1", "bob has had control"));

        assertThat(store.operations).isEmpty();
        assertThat(cloud.controls().control(link.id()).isHeldBy("bob")).isTrue();
    }

    @Test
    void hearsOfWhatItHadWorkedOut() {
        begin();

        wish("compute 42");

        await().until(() -> heard().equals(List.of("asked", "42")));
        assertReplays();
    }

    @Test
    void hearsThatThereIsNoRoomForWorkingSomethingOut() {
        Watch.Work.mayEnd = new CountDownLatch(1);
        begin();

        for (int i = 0; i < 19; i++) {
            wish("compute " + i);
        }

        await().until(() -> heard().contains("failed: Too much is being worked out already."));
        Watch.Work.mayEnd.countDown();
        await().until(() -> heard().contains("17"));
    }

    @Test
    void refusesWhatItDoesNotTake() {
        begin();

        assertThatThrownBy(() -> wish("no"))
                .isInstanceOfSatisfying(
                        Operations.Refused.class,
                        refused -> assertThat(refused.why()).isEqualTo("Not that."));
        assertThat(store.journal).hasSize(1);
    }

    @Test
    void givesItsDronesBackWhenItIsOver() {
        begin();

        wish("stop");

        assertThat(isHeldByIt(link.id())).isFalse();
        assertThat(operations.underWay(Watch.KIND)).isEmpty();
        assertThat(operations.find(Watch.KIND, ID).orElseThrow().saved().endedAt())
                .isNotNull();
        assertThatThrownBy(() -> wish("arm")).isInstanceOf(Operations.Refused.class);
    }

    @Test
    void conductsTheOthersWhenOneCannotBeRead() {
        begin();
        SavedOperation broken = SavedOperation.begun(
                new OperationId("w0"),
                Watch.KIND.name(),
                new SavedOperation.Owner("bob", OrganisationId.HOME),
                "broken",
                Instant.now().minusSeconds(60));
        store.operations.put(broken.id(), broken);

        restart();

        await().until(() -> heard().contains("resumed"));
        assertThat(operations.troubles())
                .containsExactly("“broken” of bob cannot be taken up again: no state of a watch: ");
    }
}
