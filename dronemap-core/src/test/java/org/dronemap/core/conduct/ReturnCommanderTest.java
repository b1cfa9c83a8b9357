package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.CloudFixtures;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.time.SteppedTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How a drone is called home that an operation leaves. */
class ReturnCommanderTest {
    private static final Command RETURN = new Command.ReturnToLaunch();
    private static final LeaseHolder.Operation BY = new LeaseHolder.Operation("w1", "ann", "The watch w1");
    private static final Watchdog PATIENT =
            new Watchdog(Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(10));

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-03-04T05:06:07Z"));
    private final Lanes lanes = new Lanes(time, 2);
    private final StoreWriter journal = new StoreWriter(time);
    private final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();
    private final CloudManager cloud = new CloudManager(
            lanes,
            PATIENT,
            time,
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    new CloudFixtures.InMemoryCommandStore(),
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("drone-1"));
    private final DroneGateway crew = new DroneGateway(cloud, "watch");
    private final ReturnCommander wayHome = new ReturnCommander(crew, time);
    private DroneLink link;

    @BeforeEach
    void hovers() {
        link = CloudFixtures.bound(cloud.admit(new Claim(
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle),
                CloudFixtures.copter(null),
                null,
                true,
                0)));
        can();
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        assertThat(crew.engage(BY, link.id())).isEmpty();
        time.settle();
    }

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    private void hear(DroneEvent event) {
        link.lane().execute(() -> link.accept(event));
        time.settle();
    }

    private void can(Capability... missing) {
        Set<Capability> able = EnumSet.allOf(Capability.class);
        able.removeAll(List.of(missing));
        hear(new DroneEvent.Identified(
                CloudFixtures.copter(null),
                new Capabilities(
                        able, List.of("GUIDED", "RTL"), Map.of("GUIDED", Steering.ORDERS, "RTL", Steering.HOME))));
    }

    private boolean isSeenTo() {
        boolean seenTo = wayHome.commandReturn(BY, cloud.drone(link.id()).orElseThrow());
        time.settle();
        return seenTo;
    }

    private void answers(Outcome outcome) {
        vehicle.reports.values().forEach(report -> report.ended(outcome));
        vehicle.reports.clear();
        time.settle();
    }

    private boolean isHeld() {
        return crew.whyNotHeld(BY, link.id()) == null;
    }

    @Test
    void callsItAgainUntilItIsOnItsWay() {
        assertThat(isSeenTo()).isFalse();
        assertThat(vehicle.performed).containsExactly(RETURN);
        answers(new Outcome.Refused("vehicle", "no", OutcomeCode.VEHICLE_REFUSED));

        time.advance(Duration.ofSeconds(4));
        assertThat(isSeenTo()).isFalse();
        assertThat(vehicle.performed).as("not all the time").hasSize(1);
        time.advance(Duration.ofSeconds(2));
        assertThat(isSeenTo()).isFalse();
        assertThat(vehicle.performed).as("a refusal is not the end of it").containsExactly(RETURN, RETURN);

        hear(new DroneEvent.ModeReported("RTL", true));
        assertThat(isSeenTo()).isTrue();
        assertThat(isHeld()).isFalse();
    }

    @Test
    void landsWhatCannotReturnAndHoldsWhatCannotLand() {
        can(Capability.RETURN_TO_LAUNCH);
        assertThat(isSeenTo()).isFalse();
        assertThat(vehicle.performed).containsExactly(new Command.Land());
        answers(new Outcome.Refused("vehicle", "no", OutcomeCode.VEHICLE_REFUSED));

        can(Capability.RETURN_TO_LAUNCH, Capability.LAND);
        time.advance(Duration.ofSeconds(6));
        assertThat(isSeenTo()).isFalse();
        assertThat(vehicle.performed).containsExactly(new Command.Land(), new Command.Hold());
    }

    @Test
    void disarmsWhatStands() {
        hear(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));

        assertThat(isSeenTo()).isFalse();
        assertThat(vehicle.performed).containsExactly(new Command.Disarm(false));
        hear(new DroneEvent.ModeReported("GUIDED", false));
        assertThat(isSeenTo()).isTrue();
        assertThat(isHeld()).isFalse();
    }

    /** It is never in the air, wherever it is. */
    @Test
    void callsARoverHomeInsteadOfDisarmingItOnItsWay() {
        Identification rover = new Identification(VehicleKind.ROVER, "ArduPilot", "ArduRover", "4.5.6", null);
        hear(new DroneEvent.Identified(
                rover,
                new Capabilities(
                        EnumSet.allOf(Capability.class),
                        List.of("GUIDED", "RTL"),
                        Map.of("GUIDED", Steering.ORDERS, "RTL", Steering.HOME))));

        assertThat(isSeenTo()).isFalse();
        assertThat(vehicle.performed).containsExactly(RETURN);
    }

    @Test
    void leavesItToWhoeverTookIt() {
        assertThat(cloud.controls().apply(link.id(), new LeaseEvent.TakeOver("bob", "look out")))
                .isNotNull();
        time.settle();

        assertThat(isSeenTo()).isTrue();
        assertThat(vehicle.performed).isEmpty();
    }
}
