package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
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
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneValidity;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Steering a drone, from the gate to the wire, and what follows when nobody does any more. */
class SetpointGateTest {
    private static final Instant BEGAN = Instant.parse("2026-03-04T05:06:07Z");
    private static final CommandGate.Source ANN = source("ann", Role.OPERATOR);
    private static final CommandGate.Source BOB = source("bob", Role.OPERATOR);
    private static final Setpoint NORTHWARD = new Setpoint.Velocity(Frame.EARTH, 3, 0, 0, Facing.ANY);
    private static final Setpoint NO_SPEED = new Setpoint.Velocity(Frame.EARTH, 0, 0, 0, Facing.ANY);
    private static final Setpoint PUSHED = new Setpoint.Sticks(0.5, 0, 0, 0);
    private static final Setpoint MIDDLE = new Setpoint.Sticks(0, 0, 0, 0);
    private static final Geodetic HERE = new Geodetic(47.3977, 8.5456);

    private final SteppedTime time = new SteppedTime(BEGAN);
    private final Lanes lanes = new Lanes(time, 1);
    private final StoreWriter journal = new StoreWriter(time);
    private final CloudFixtures.InMemoryCommandStore log = new CloudFixtures.InMemoryCommandStore();
    private final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();
    private final CloudManager cloud = new CloudManager(
            lanes,
            new Watchdog(Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(10)),
            time,
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    log,
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("drone-1"));
    private final SetpointGate setpoints = cloud.setpoints();
    private DroneLink link;

    private static CommandGate.Source source(String name, Role role) {
        return new CommandGate.Source(new Principal(name, role), "outlet");
    }

    @BeforeEach
    void fly() {
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle);
        link = CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        hear(new DroneEvent.Identified(
                CloudFixtures.copter(null),
                new Capabilities(
                        Set.of(Capability.values()),
                        List.of("GUIDED", "BRAKE", "LOITER", "AUTO"),
                        Map.of(
                                "GUIDED",
                                Steering.ORDERS,
                                "BRAKE",
                                Steering.STANDS,
                                "LOITER",
                                Steering.STICKS,
                                "AUTO",
                                Steering.MISSION))));
        hear(new DroneEvent.HomeReported(new Home(HERE, 400.0)));
        hear(new DroneEvent.PositionReported(new Position(HERE, 420.0, 20.0)));
        hear(new DroneEvent.MotionReported(new Motion(0.0, null, 0.0, 0.0)));
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
    }

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    @Test
    void handsSetpointsOnAndTellsTheVehicleToStandOnceNoMoreCome() {
        assertThat(steer(ANN, NORTHWARD)).isEmpty();
        awaitSaid(said -> said.equals(List.of(NORTHWARD, NO_SPEED, NO_SPEED, NO_SPEED)));

        CommandRecord turn = ended();
        assertThat(turn.by()).isEqualTo("ann");
        assertThat(turn.face()).isEqualTo("outlet");
        assertThat(turn.summary()).isEqualTo("steer by speeds");
        assertThat(turn.epoch()).isPositive();
        assertThat(turn.outcome())
                .isEqualTo(new Outcome.TimedOut(
                        "Nothing more came for half a second; the vehicle was told to stand still."));
        // In a mode for orders no speed is a place to stay.
        assertThat(vehicle.performed).isEmpty();
    }

    @Test
    void isOneEntryInTheLogForAsLongAsItGoesOn() {
        for (int count = 0; count < 20; count++) {
            Setpoint next = new Setpoint.Velocity(Frame.EARTH, 3, 0.1 * count, 0, Facing.ANY);
            int before = vehicle.setpoints.size();
            assertThat(steer(ANN, next)).isEmpty();
            until(() -> vehicle.setpoints.size() > before);
        }

        until(() -> log.records.size() == 1);
        CommandRecord turn = log.records.values().iterator().next();
        assertThat(turn.phase()).isEqualTo(CommandPhase.ACCEPTED);
    }

    @Test
    void onlyTheNewestWaitsForABusyLane() {
        link.lane().execute(() -> {
            for (int speed = 1; speed <= 50; speed++) {
                assertThat(steer(ANN, new Setpoint.Velocity(Frame.EARTH, speed, 0, 0, Facing.ANY)))
                        .isEmpty();
            }
        });

        awaitSaid(said -> said.contains(NO_SPEED));
        assertThat(vehicle.setpoints.get(0)).isEqualTo(new Setpoint.Velocity(Frame.EARTH, 50, 0, 0, Facing.ANY));
        assertThat(vehicle.setpoints.get(1)).isEqualTo(NO_SPEED);
    }

    @Test
    void handsOffTheSticksBringsItToAHoldAtOnce() {
        hear(new DroneEvent.ModeReported("LOITER", true));
        assertThat(steer(ANN, PUSHED)).isEmpty();
        setpoints.stopSteering(ANN, link.id());

        awaitSaid(said -> said.size() >= 2);
        assertThat(vehicle.setpoints.subList(0, 2)).containsExactly(PUSHED, MIDDLE);
        // Sticks that nobody holds keep nothing.
        until(() -> vehicle.performed.equals(List.of(new Command.Hold())));
        assertThat(ended().outcome()).isEqualTo(new Outcome.Succeeded());
    }

    @Test
    void whoTakesControlStopsWhatTheOtherSteeredBeforeAnythingElse() {
        assertThat(steer(ANN, NORTHWARD)).isEmpty();
        awaitSaid(said -> said.contains(NORTHWARD));
        cloud.controls().apply(link.id(), new LeaseEvent.TakeOver("bob", "smoke"));
        cloud.gate().submit(BOB, link.id(), new CommandId("bobs-goto"), goTo());
        assertThat(steer(ANN, NORTHWARD))
                .hasValueSatisfying(why -> assertThat(why).startsWith("bob has had control"));

        until(() -> vehicle.performed.equals(List.of(goTo())));
        assertThat(vehicle.setpoints).containsExactly(NORTHWARD, NO_SPEED);
        assertThat(ended().outcome())
                .isInstanceOfSatisfying(
                        Outcome.Superseded.class,
                        superseded -> assertThat(superseded.reason()).startsWith("Control has changed hands."));
    }

    @Test
    void aCommandTakesTheHelmAndNothingIsSteeredWhileItIsUnderWay() {
        assertThat(steer(ANN, NORTHWARD)).isEmpty();
        awaitSaid(said -> said.contains(NORTHWARD));
        cloud.gate().submit(ANN, link.id(), new CommandId("anns-goto"), goTo());
        assertThat(steer(ANN, NORTHWARD))
                .hasValueSatisfying(why -> assertThat(why).startsWith("Steer when what is under way has ended: go to"));

        assertThat(ended().outcome())
                .isInstanceOfSatisfying(
                        Outcome.Superseded.class,
                        superseded -> assertThat(superseded.reason()).startsWith("Replaced by: go to"));
        assertThat(vehicle.setpoints).containsExactly(NORTHWARD);
    }

    @Test
    void aSupervisorsHoldEndsWhatSomebodyElseSteersAlthoughThatOneKeepsControl() {
        assertThat(steer(ANN, NORTHWARD)).isEmpty();
        awaitSaid(said -> said.contains(NORTHWARD));

        cloud.gate()
                .submit(source("carl", Role.SUPERVISOR), link.id(), new CommandId("carls-hold"), new Command.Hold());

        until(() -> vehicle.performed.equals(List.of(new Command.Hold())));
        assertThat(ended().outcome())
                .isInstanceOfSatisfying(
                        Outcome.Superseded.class,
                        superseded -> assertThat(superseded.reason()).startsWith("Replaced by: hold"));
        assertThat(vehicle.setpoints).containsExactly(NORTHWARD);
        assertThat(cloud.controls().control(link.id()).sentence()).contains("ann");
    }

    @Test
    void whoMayNotIsToldWhyAndNothingIsSaid() {
        assertThat(steer(source("eve", Role.VIEWER), NORTHWARD))
                .hasValueSatisfying(why -> assertThat(why).contains("look, not command"));
        assertThat(steer(ANN, PUSHED))
                .contains("In GUIDED it is not to be steered so; change its mode to LOITER first.");
        hear(new DroneEvent.ModeReported("BRAKE", true));
        assertThat(steer(ANN, NORTHWARD))
                .contains("In BRAKE it is not to be steered so; change its mode to GUIDED first.");
        hear(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
        assertThat(steer(ANN, NORTHWARD)).contains("Take off first.");

        assertThat(steer(ANN, MIDDLE)).as("hands off the sticks").isPresent();
        awaitRefusals(4);
        assertThat(vehicle.setpoints).isEmpty();
    }

    @Test
    void whoGoesOnTryingIsWrittenDownOnce() {
        CommandGate.Source eve = source("eve", Role.VIEWER);
        for (int again = 0; again < 20; again++) {
            assertThat(steer(eve, NORTHWARD)).isPresent();
        }
        assertThat(steer(BOB, PUSHED)).isPresent();

        List<CommandRecord> refused = awaitRefusals(2);
        assertThat(refused).extracting(CommandRecord::by).containsExactlyInAnyOrder("eve", "bob");
    }

    /** All that was written down: so many, each of which says why. */
    private List<CommandRecord> awaitRefusals(int count) {
        until(() -> log.records.size() >= count);
        List<CommandRecord> all = List.copyOf(log.records.values());
        assertThat(all).hasSize(count).allSatisfy(record -> {
            assertThat(record.type()).isEqualTo("Steer");
            assertThat(record.outcome()).isInstanceOf(Outcome.Refused.class);
        });
        return all;
    }

    @Test
    void isNotSentWhereOnlyASlipWouldSendIt() {
        Geodetic nowhere = new Geodetic(0, 0);
        Setpoint track = new Setpoint.Track(nowhere, Altitude.aboveHome(20), null, Facing.ANY);
        assertThat(steer(ANN, track))
                .hasValueSatisfying(why -> assertThat(why).contains("5335 km").contains("at most 100 km"));

        CommandRecord refused = cloud.gate()
                .submit(ANN, link.id(), new CommandId("to-nowhere"), new Command.GoTo(nowhere, Altitude.aboveHome(20)));
        assertThat(refused.outcome())
                .isInstanceOfSatisfying(
                        Outcome.Refused.class,
                        answer -> assertThat(answer.reason()).contains("at most 100 km"));
    }

    @Test
    void isNotLedToAPlaceThatMovesIntoAZone() {
        cloud.zones().put(List.of(dam()));
        Geodetic near = new Geodetic(47.39771, 8.5456);
        assertThat(steer(ANN, led(near, -3))).isEmpty();
        assertThat(steer(ANN, led(near, 3)))
                .hasValueSatisfying(why -> assertThat(why).contains("the dam"));
    }

    private static Setpoint led(Geodetic place, double northward) {
        Setpoint.Velocity moving = new Setpoint.Velocity(Frame.EARTH, northward, 0, 0, Facing.ANY);
        return new Setpoint.Track(place, Altitude.aboveHome(20), moving, Facing.ANY);
    }

    @Test
    void isNotSteeredIntoAZoneAndStandsWhenItIsTried() {
        cloud.zones().put(List.of(dam()));
        assertThat(steer(ANN, new Setpoint.Velocity(Frame.EARTH, -3, 0, 0, Facing.ANY)))
                .isEmpty();
        assertThat(steer(ANN, NORTHWARD))
                .hasValueSatisfying(why -> assertThat(why).contains("the dam"));

        awaitSaid(said -> said.contains(NO_SPEED));
        assertThat(vehicle.setpoints).doesNotContain(NORTHWARD);
        assertThat(ended().outcome())
                .isInstanceOfSatisfying(
                        Outcome.Refused.class,
                        refused -> assertThat(refused.reason()).contains("the dam"));
    }

    @Test
    void whereNobodyKnowsWhereSpeedsLeadNoneAreTakenAmongZones() {
        Setpoint ahead = new Setpoint.Velocity(Frame.VEHICLE, 3, 0, 0, Facing.ANY);
        hear(new DroneEvent.MotionReported(new Motion(0.0, null, 0.0, null)));
        assertThat(steer(ANN, ahead)).isEmpty();
        cloud.zones().put(List.of(dam()));

        assertThat(steer(ANN, ahead))
                .hasValueSatisfying(why -> assertThat(why).contains("not known").contains("the dam"));
        assertThat(steer(ANN, new Setpoint.Velocity(Frame.VEHICLE, 0, 0, -1, Facing.ANY)))
                .as("straight up")
                .isEmpty();
    }

    @Test
    void whatHasNoModesStandsByZerosAlone() {
        hear(new DroneEvent.Identified(
                CloudFixtures.copter(null), new Capabilities(Set.of(Capability.values()), List.of())));
        assertThat(steer(ANN, NORTHWARD)).isEmpty();
        setpoints.stopSteering(ANN, link.id());

        awaitSaid(said -> said.equals(List.of(NORTHWARD, NO_SPEED, NO_SPEED, NO_SPEED)));
        assertThat(vehicle.performed).isEmpty();
        assertThat(steer(ANN, NORTHWARD)).as("and goes on at once").isEmpty();
    }

    private static Command.GoTo goTo() {
        return new Command.GoTo(new Geodetic(47.398, 8.546), Altitude.aboveHome(20));
    }

    private static Zone dam() {
        return new Zone(
                "z1",
                "the dam",
                new FenceArea.Circle(false, new Geodetic(47.3979, 8.5456), 15),
                AltitudeBand.ALL,
                ZoneBinding.EVERYBODY,
                ZoneValidity.ALWAYS,
                BreachAction.HOLD,
                "ann",
                Instant.EPOCH);
    }

    private Optional<String> steer(CommandGate.Source source, Setpoint setpoint) {
        return setpoints.steer(source, link.id(), setpoint).map(Refusal::sentence);
    }

    private void hear(DroneEvent event) {
        link.lane().execute(() -> link.accept(event));
        time.settle();
    }

    private void until(BooleanSupplier holds) {
        SteppedUntil.until(time, holds);
    }

    private void awaitSaid(Predicate<List<Setpoint>> wanted) {
        until(() -> wanted.test(List.copyOf(vehicle.setpoints)));
    }

    /** Who was let to the helm had control. */
    private static boolean isTurn(CommandRecord record) {
        return record.type().equals("Steer") && record.epoch() != null;
    }

    private CommandRecord ended() {
        until(() -> log.records.values().stream().anyMatch(record -> isTurn(record) && record.outcome() != null));
        return log.records.values().stream()
                .filter(SetpointGateTest::isTurn)
                .findFirst()
                .orElseThrow();
    }
}
