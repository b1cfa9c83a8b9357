package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dronemap.core.cloud.CloudFixtures.refused;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.OnboardStorage;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class CommandGateTest {
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    private static final CommandGate.Source OPERATOR =
            new CommandGate.Source(new Principal("ann", Role.OPERATOR), "rest");
    private static final CommandGate.Source VIEWER = new CommandGate.Source(new Principal("vic", Role.VIEWER), "rest");
    private static final Command UPLOAD = new Command.UploadMission(new Mission(List.of(new MissionItem.Land())));

    private final Lanes lanes = new Lanes(new RealTime(), 2);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final CloudFixtures.InMemoryCommandStore store = new CloudFixtures.InMemoryCommandStore();
    private final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();
    private final AtomicInteger numbers = new AtomicInteger();
    private final CloudManager cloud = new CloudManager(
            lanes,
            Watchdog.DEFAULT,
            new RealTime(),
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    store,
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("drone-" + numbers.incrementAndGet()));
    private final CommandGate gate = cloud.gate();
    private DroneLink link;

    @BeforeEach
    void connect() {
        link = CloudFixtures.bound(cloud.admit(new Claim(session(false), CloudFixtures.copter(null), null, true, 0)));
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), CloudFixtures.ALL));
        hear(new DroneEvent.ModeReported("GUIDED", false));
    }

    @AfterEach
    void close() {
        store.answers.countDown();
        lanes.close();
        journal.close();
    }

    @Test
    void carriesACommandToItsEndAndWritesBothEnds() {
        CommandRecord sent = gate.submit(OPERATOR, link.id(), id("arm-00001"), new Command.Arm());
        CompletableFuture<CommandRecord> end = gate.end(sent.id());
        assertThat(sent.phase()).isEqualTo(CommandPhase.SENT);
        assertThat(store.records).containsKey(sent.id());
        report(sent).accepted();
        assertThat(gate.find(sent.id())).map(CommandRecord::phase).contains(CommandPhase.ACCEPTED);
        report(sent).ended(new Outcome.Succeeded());
        assertThat(end)
                .succeedsWithin(5, TimeUnit.SECONDS)
                .satisfies(done -> assertThat(done.outcome()).isEqualTo(new Outcome.Succeeded()));
        assertThat(store.records.get(sent.id()).outcome()).isEqualTo(new Outcome.Succeeded());
    }

    @Test
    void actsOnceForTheSameIdTwice() {
        gate.submit(OPERATOR, link.id(), id("twice-001"), new Command.Arm());
        CommandRecord again = gate.submit(OPERATOR, link.id(), id("twice-001"), new Command.Arm());
        report(again).ended(new Outcome.Succeeded());
        await().until(() -> store.records.get(again.id()).outcome() != null);
        gate.submit(OPERATOR, link.id(), id("twice-001"), new Command.Arm());
        assertThat(vehicle.performed).hasSize(1);
    }

    @Test
    void refusesAViewerAndSendsNothing() {
        CommandRecord refused = gate.submit(VIEWER, link.id(), id("viewer-01"), new Command.Arm());
        assertThat(refused.outcome())
                .isEqualTo(refused(
                        OutcomeCode.ROLE_MAY_NOT_COMMAND,
                        "Your role may look, not command; ask an administrator for the operator role."));
        assertNothingSent();
    }

    @Test
    void saysWhatIsMissingBeforeTakeOff() {
        CommandRecord refused = gate.submit(OPERATOR, link.id(), id("takeoff-1"), new Command.TakeOff(20));
        assertThat(refused.outcome()).isEqualTo(refused(OutcomeCode.NOT_ARMED, "Arm first."));
        assertThat(store.records.get(refused.id()).outcome()).isEqualTo(refused.outcome());
        assertNothingSent();
    }

    @Test
    void letsOnePictureBeTakenAtATimeButARelayBesideIt() {
        CommandRecord first = gate.submit(OPERATOR, link.id(), id("picture-1"), new Command.TakePicture());
        CommandRecord second = gate.submit(OPERATOR, link.id(), id("picture-2"), new Command.TakePicture());
        gate.submit(OPERATOR, link.id(), id("relay-001"), new Command.SetRelay(0, RelaySetting.TOGGLE));

        assertThat(gate.end(second.id()))
                .succeedsWithin(5, TimeUnit.SECONDS)
                .satisfies(refused -> assertThat(refused.outcome())
                        .isEqualTo(refused(
                                OutcomeCode.COMMAND_UNDER_WAY,
                                "Wait for the end of what is under way: take a picture.")));
        await().until(() -> vehicle.performed.size() == 2);
        report(first).ended(new Outcome.Succeeded());
    }

    @Test
    void remembersTheParametersAndLogsOfADrone() {
        assertThat(cloud.onBoard(link.id())).isEqualTo(OnboardStorage.UNKNOWN);
        Parameter height = new Parameter("RTL_ALT", ParameterType.INT16, 1500);

        hear(new DroneEvent.ParametersRead(List.of(height)));
        hear(new DroneEvent.ParameterReported(height.withValue(2000)));
        hear(new DroneEvent.LogsRead(List.of(new VehicleLog(1, null, 90))));

        await().until(() -> cloud.onBoard(link.id()).logs() != null);
        assertThat(cloud.onBoard(link.id()).parameters().all()).containsExactly(height.withValue(2000));
        assertThat(cloud.onBoard(link.id()).parameters().readAt()).isNotNull();
    }

    @Test
    void refusesWhatTheVehicleCannotDo() {
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), Capabilities.NONE));

        CommandRecord refused = gate.submit(OPERATOR, link.id(), id("cannot-01"), new Command.Arm());

        assertThat(refused.outcome())
                .isEqualTo(refused(OutcomeCode.CAPABILITY_MISSING, "This vehicle (ArduCopter) cannot arm."));
        assertNothingSent();
    }

    @Test
    void refusesAModeThatTheVehicleDoesNotHave() {
        CommandRecord refused = gate.submit(OPERATOR, link.id(), id("mode-0001"), new Command.SetMode("WARP"));
        assertThat(refused.outcome())
                .isEqualTo(
                        refused(OutcomeCode.MODE_UNKNOWN, "This vehicle has no mode WARP; it knows GUIDED, LOITER."));
    }

    @Test
    void doesNotSayThatAVehicleCannotWhatItWasNotAskedYet() {
        link = CloudFixtures.bound(
                cloud.admit(new Claim(session(false, 5002), CloudFixtures.copter(null), null, true, 0)));
        hear(new DroneEvent.ModeReported("GUIDED", false));

        CommandRecord refused = gate.submit(OPERATOR, link.id(), id("early-001"), new Command.Arm());

        assertThat(refused.outcome())
                .isEqualTo(refused(
                        OutcomeCode.CAPABILITIES_UNKNOWN,
                        "It is not known yet what this vehicle can do; try again in a moment."));
    }

    @Test
    void neverCommandsARecording() {
        DroneLink recording =
                CloudFixtures.bound(cloud.admit(new Claim(session(true), CloudFixtures.copter(null), null, true, 0)));
        on(recording, new DroneEvent.Identified(CloudFixtures.copter(null), CloudFixtures.ALL));

        CommandRecord refused = gate.submit(OPERATOR, recording.id(), id("replay-01"), new Command.Arm());

        assertThat(refused.outcome())
                .isEqualTo(refused(OutcomeCode.DRONE_IS_A_RECORDING, "This is a recording; it cannot be commanded."));
        assertNothingSent();
    }

    @Test
    void letsANewerFlightCommandReplaceTheOlder() {
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        CommandRecord mode = gate.submit(OPERATOR, link.id(), id("older-001"), new Command.SetMode("LOITER"));
        report(mode);
        CommandRecord land = gate.submit(OPERATOR, link.id(), id("newer-001"), new Command.Land());
        report(land);

        await().untilAsserted(() -> assertThat(store.records.get(mode.id()).outcome())
                .isEqualTo(new Outcome.Superseded("Replaced by: land.")));
        assertThat(vehicle.cancelled).containsExactly(mode.id());
    }

    @Test
    void letsAMissionTransferFinishBeforeTheNext() {
        report(gate.submit(OPERATOR, link.id(), id("upload-01"), UPLOAD));
        CommandRecord second = gate.submit(OPERATOR, link.id(), id("upload-02"), UPLOAD);

        assertThat(gate.end(second.id()))
                .succeedsWithin(5, TimeUnit.SECONDS)
                .satisfies(done -> assertThat(done.outcome())
                        .isInstanceOfSatisfying(
                                Outcome.Refused.class,
                                refused -> assertThat(refused.reason()).startsWith("Another mission transfer")));
        assertThat(gate.transfer(link.id())).contains(UPLOAD.summary());
    }

    @Test
    void letsATransferBeginWhileTheOutcomeOfTheLastIsBeingWritten() {
        CommandRecord first = gate.submit(OPERATOR, link.id(), id("upload-01"), UPLOAD);
        store.disk = new CountDownLatch(1);
        report(first).ended(new Outcome.Succeeded());
        assertThat(gate.transfer(link.id())).isEmpty();

        CommandRecord second = gate.submit(OPERATOR, link.id(), id("upload-02"), UPLOAD);
        report(second).ended(new Outcome.Succeeded());
        store.disk.countDown();

        assertThat(gate.end(second.id()))
                .succeedsWithin(5, TimeUnit.SECONDS)
                .satisfies(done -> assertThat(done.outcome()).isEqualTo(new Outcome.Succeeded()));
    }

    @Test
    void tellsAnOutcomeOnlyWhenItIsWritten() {
        CommandRecord sent = gate.submit(OPERATOR, link.id(), id("arm-00003"), new Command.Arm());
        CompletableFuture<CommandRecord> end = gate.end(sent.id());
        store.disk = new CountDownLatch(1);
        report(sent).ended(new Outcome.Succeeded());

        assertThat(gate.find(sent.id()).orElseThrow().outcome()).isNull();
        assertThat(gate.commandsOf(link.id(), 10))
                .filteredOn(told -> told.id().equals(sent.id()))
                .singleElement()
                .satisfies(told -> assertThat(told.outcome()).isNull());
        store.disk.countDown();

        assertThat(end).succeedsWithin(5, TimeUnit.SECONDS);
        assertThat(gate.find(sent.id()).orElseThrow().outcome()).isEqualTo(new Outcome.Succeeded());
    }

    @Test
    void letsAHomeBeSetInTheMiddleOfAFlightCommand() {
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        report(gate.submit(OPERATOR, link.id(), id("flight-01"), new Command.Land()));

        report(gate.submit(OPERATOR, link.id(), id("home-0001"), new Command.SetHome(null, null)));

        assertThat(vehicle.cancelled).isEmpty();
        assertThat(vehicle.performed).containsExactly(new Command.Land(), new Command.SetHome(null, null));
    }

    @Test
    void sendsNothingThatItCouldNotWriteDown() {
        store.broken = true;

        assertThatThrownBy(() -> gate.submit(OPERATOR, link.id(), id("nodisk-01"), new Command.Arm()))
                .hasMessage("the disk is full");
        assertNothingSent();
    }

    @Test
    void bringsADroneHomeEvenWhenNothingCanBeWritten() {
        hear(new DroneEvent.ModeReported("GUIDED", true));
        store.broken = true;

        CommandRecord home = gate.submit(OPERATOR, link.id(), id("nodisk-02"), new Command.ReturnToLaunch());
        CompletableFuture<CommandRecord> end = gate.end(home.id());
        report(home).ended(new Outcome.Succeeded());

        assertThat(end).succeedsWithin(5, TimeUnit.SECONDS);
        assertThat(vehicle.performed).containsExactly(new Command.ReturnToLaunch());
    }

    @Test
    void bringsADroneHomeThoughTheStoreDoesNotAnswer() {
        hear(new DroneEvent.ModeReported("GUIDED", true));
        store.answers = new CountDownLatch(1);

        CompletableFuture<CommandRecord> given = CompletableFuture.supplyAsync(
                () -> gate.submit(OPERATOR, link.id(), id("nodisk-03"), new Command.ReturnToLaunch()));

        assertThat(given).succeedsWithin(PATIENCE);
        CommandRecord home = given.join();
        await().atMost(PATIENCE).until(() -> vehicle.performed.equals(List.of(new Command.ReturnToLaunch())));
        assertThat(home.outcome()).isNull();
        store.answers.countDown();
        CompletableFuture<CommandRecord> end = gate.end(home.id());
        report(home).ended(new Outcome.Succeeded());
        assertThat(end).succeedsWithin(PATIENCE);
        assertThat(store.records.get(home.id()).outcome()).isEqualTo(new Outcome.Succeeded());
    }

    @Test
    void aRuleHoldsADroneThoughTheStoreDoesNotAnswer() {
        hear(new DroneEvent.Identified(
                CloudFixtures.copter(null),
                new Capabilities(Set.of(Capability.values()), List.of("LOITER"), Map.of("LOITER", Steering.STICKS))));
        hear(new DroneEvent.ModeReported("LOITER", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        assertThat(cloud.setpoints().steer(OPERATOR, link.id(), new Setpoint.Sticks(0.5, 0, 0, 0)))
                .isEmpty();
        store.answers = new CountDownLatch(1);

        assertThat(cloud.setpoints().steer(OPERATOR, link.id(), new Setpoint.Sticks(0, 0, 0, 0)))
                .isEmpty();

        await().atMost(PATIENCE).until(() -> vehicle.performed.equals(List.of(new Command.Hold())));
        store.answers.countDown();
        await().atMost(PATIENCE)
                .until(() -> store.records.values().stream()
                        .anyMatch(record ->
                                record.by().equals("dronemap") && record.type().equals("Hold")));
    }

    @Test
    void bringsNoDroneHomeTwiceForTheSameId() {
        hear(new DroneEvent.ModeReported("GUIDED", true));
        CommandRecord home = gate.submit(OPERATOR, link.id(), id("home-0002"), new Command.ReturnToLaunch());
        CompletableFuture<CommandRecord> end = gate.end(home.id());
        report(home).ended(new Outcome.Succeeded());
        assertThat(end).succeedsWithin(PATIENCE);

        CommandRecord again = gate.submit(OPERATOR, link.id(), id("home-0002"), new Command.ReturnToLaunch());

        assertThat(again.outcome()).isEqualTo(new Outcome.Succeeded());
        assertThat(vehicle.performed).containsExactly(new Command.ReturnToLaunch());
    }

    @Test
    void knowsNoDroneThatIsNotThere() {
        assertThatThrownBy(() -> gate.submit(OPERATOR, new DroneId("nobody"), id("nobody-01"), new Command.Arm()))
                .isInstanceOf(UnknownDroneException.class)
                .hasMessage("There is no drone nobody.");
    }

    private LinkSession session(boolean replay) {
        return session(replay, 14601);
    }

    private LinkSession session(boolean replay, int port) {
        return new LinkSession(new DroneKey("127.0.0.1", port, 1), "udp", replay, "ArduCopter 1", vehicle);
    }

    private void hear(DroneEvent event) {
        on(link, event);
    }

    /** Delivers an event and waits until the lane took it in. */
    private static void on(DroneLink link, DroneEvent event) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        link.lane().execute(() -> {
            link.accept(event);
            done.complete(null);
        });
        assertThat(done).succeedsWithin(5, TimeUnit.SECONDS);
    }

    private VehicleChannel.Report report(CommandRecord command) {
        await().until(() -> vehicle.reports.containsKey(command.id()));
        return vehicle.reports.get(command.id());
    }

    private void assertNothingSent() {
        on(link, new DroneEvent.ModeReported("GUIDED", false));
        assertThat(vehicle.performed).isEmpty();
    }

    private static CommandId id(String value) {
        return new CommandId(value);
    }
}
