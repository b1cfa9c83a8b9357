package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
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

class ZoneWatchTest {
    private static final Geodetic HERE = new Geodetic(47.4, 8.5);
    private static final Geodetic NORTH = new Geodetic(47.41, 8.5);
    private static final Instant BEGAN = Instant.parse("2026-03-04T05:06:07Z");
    private static final CommandGate.Source BOB = new CommandGate.Source(new Principal("bob", Role.OPERATOR), "rest");

    private final SteppedTime time = new SteppedTime(BEGAN);
    private final Lanes lanes = new Lanes(time, 2);
    private final StoreWriter journal = new StoreWriter(time);
    private final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();
    private final CloudManager cloud = new CloudManager(
            lanes,
            Watchdog.DEFAULT,
            time,
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    new CloudFixtures.InMemoryCommandStore(),
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("drone-1"));
    private DroneLink link;

    @BeforeEach
    void fly() {
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle);
        link = CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        hear(new DroneEvent.Identified(
                CloudFixtures.copter(null),
                new Capabilities(
                        Set.of(Capability.values()),
                        List.of("GUIDED", "AUTO", "RTL"),
                        Map.of("AUTO", Steering.MISSION, "RTL", Steering.SAFETY))));
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PositionReported(new Position(HERE, 470.0, 20.0)));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        until(() -> cloud.drone(link.id()).orElseThrow().airborne());
    }

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    @Test
    void actsAtOnceOnAZoneThatIsPutOverADrone() {
        cloud.zones().put(List.of(around(HERE, BreachAction.LAND, ZoneBinding.EVERYBODY)));

        until(() -> vehicle.performed.contains(new Command.Land()));
        assertThat(said()).contains("It has entered the no-fly zone “Accident” and is told: land.");
    }

    @Test
    void triesAgainWhenItFails() {
        cloud.zones().put(List.of(around(HERE, BreachAction.HOLD, ZoneBinding.EVERYBODY)));
        until(() -> vehicle.performed.size() == 1);

        vehicle.reports.values().forEach(report -> report.ended(new Outcome.TimedOut("no answer within 3 s")));

        until(() -> vehicle.performed.size() == 2);
        assertThat(vehicle.performed).containsExactly(new Command.Hold(), new Command.Hold());
    }

    @Test
    void leavesADroneAloneThatIsOnItsWayHome() {
        hear(new DroneEvent.ModeReported("RTL", true));

        cloud.zones().put(List.of(around(HERE, BreachAction.HOLD, ZoneBinding.EVERYBODY)));

        until(() -> said().stream().anyMatch(text -> text.contains("on its way home or down")));
        assertThat(vehicle.performed).isEmpty();
    }

    @Test
    void tellsADroneAgainThatFliesOnInside() {
        hear(new DroneEvent.ModeReported("AUTO", true));
        cloud.zones().put(List.of(around(HERE, BreachAction.LAND, ZoneBinding.EVERYBODY)));
        until(() -> vehicle.performed.size() == 1);
        vehicle.reports.values().forEach(report -> report.ended(new Outcome.Succeeded()));

        keepsTellingWhereItIs();
        until(() -> vehicle.performed.size() == 2);

        assertThat(vehicle.performed).containsExactly(new Command.Land(), new Command.Land());
        assertThat(said()).contains("It is still in the no-fly zone “Accident” and is told again: land.");
    }

    @Test
    void bindsWhatAUserFliesOnceHeFliesIt() {
        cloud.zones().put(List.of(around(HERE, BreachAction.HOLD, new ZoneBinding.OfUser("bob"))));
        cloud.gate().submit(BOB, link.id(), new CommandId("turn-0001"), new Command.Turn(90));

        // The next position is looked at with bob as the pilot.
        keepsTellingWhereItIs();
        until(() -> vehicle.performed.contains(new Command.Hold()));
    }

    @Test
    void keepsAWayThroughAZoneFromTheVehicle() {
        cloud.zones().put(List.of(around(NORTH, BreachAction.HOLD, ZoneBinding.EVERYBODY)));

        CommandRecord refused = cloud.gate()
                .submit(
                        BOB,
                        link.id(),
                        new CommandId("goto-0001"),
                        new Command.GoTo(new Geodetic(47.42, 8.5), Altitude.aboveHome(20)));

        assertThat(refused.outcome())
                .isInstanceOfSatisfying(
                        Outcome.Refused.class,
                        outcome -> assertThat(outcome.reason())
                                .isEqualTo(
                                        "The way from where the drone is to the place enters the no-fly zone “Accident” after"
                                                + " 1012 m."));
        assertThat(vehicle.performed).isEmpty();
    }

    private List<String> said() {
        return cloud.drone(link.id()).orElseThrow().messages().stream()
                .map(TextMessage::text)
                .toList();
    }

    private void hear(DroneEvent event) {
        link.lane().execute(() -> link.accept(event));
    }

    private void keepsTellingWhereItIs() {
        DroneEvent here = new DroneEvent.PositionReported(new Position(HERE, 470.0, 20.0));
        time.worker("vehicle", 1).every(Duration.ZERO, Duration.ofMillis(250), () -> hear(here));
    }

    private void until(BooleanSupplier holds) {
        SteppedUntil.until(time, holds);
    }

    private static Zone around(Geodetic center, BreachAction action, ZoneBinding binding) {
        return new Zone(
                "z1",
                "Accident",
                new FenceArea.Circle(false, center, 100),
                AltitudeBand.ALL,
                binding,
                ZoneValidity.ALWAYS,
                action,
                "ann",
                BEGAN);
    }
}
