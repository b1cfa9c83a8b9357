package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneValidity;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Each way by which a drone comes down that nobody takes. */
class ReturnWatchTest extends GuidedFlightTestBase {
    private static final Command RETURN = new Command.ReturnToLaunch();
    private static final Command LAND = new Command.Land();
    private static final Outcome REFUSED = new Outcome.Refused("vehicle", "no", OutcomeCode.VEHICLE_REFUSED);
    /** 1.1 km away. */
    private static final Geodetic FAR = new Geodetic(HERE.latitudeDegrees() + 0.01, HERE.longitudeDegrees());
    /** 55 m away. */
    private static final Geodetic NEAR = new Geodetic(HERE.latitudeDegrees(), HERE.longitudeDegrees() + 0.00055);

    private static final Capabilities CAN = new Capabilities(
            Set.of(Capability.values()),
            List.of("GUIDED", "LOITER", "AUTO", "RTL", "LAND"),
            Map.of(
                    "GUIDED", Steering.ORDERS,
                    "LOITER", Steering.STICKS,
                    "AUTO", Steering.MISSION,
                    "RTL", Steering.HOME,
                    "LAND", Steering.SAFETY));

    @BeforeEach
    void isFarFromHome() {
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), CAN));
        hear(new DroneEvent.HomeReported(new Home(FAR, 600)));
        isCommandedBy(ANN);
    }

    private void isLeft() {
        apply(new LeaseEvent.Release("ann"));
    }

    private void isAt(Geodetic point, double meters) {
        hear(new DroneEvent.PositionReported(new Position(point, null, meters)));
    }

    private void has(int percent) {
        hear(new DroneEvent.BatteryReported(new Battery(percent, null, null)));
    }

    private void isToldTo(Command... commands) {
        until(() -> vehicle.performed.size() >= commands.length);
        assertThat(vehicle.performed).containsExactly(commands);
    }

    private void answers(Outcome outcome) {
        vehicle.reports.values().forEach(report -> report.ended(outcome));
        vehicle.reports.clear();
        time.settle();
    }

    private void standsStillFor(Duration how) {
        SteppedUntil.throughout(time, how, () -> true);
    }

    private List<String> alarms() {
        DroneState now = cloud.drone(link.id()).orElseThrow();
        return now.messages().stream()
                .filter(message -> message.severity() == Severity.ALERT)
                .map(message -> message.text())
                .toList();
    }

    private static Zone over(Geodetic place) {
        return over(place, 100);
    }

    private static Zone over(Geodetic place, double meters) {
        return new Zone(
                "z1",
                "Crowd",
                new FenceArea.Circle(false, place, meters),
                AltitudeBand.ALL,
                ZoneBinding.EVERYBODY,
                ZoneValidity.ALWAYS,
                BreachAction.HOLD,
                "ann",
                BEGAN);
    }

    @Test
    void returnsAndIsWatchedUntilItIsDown() {
        isLeft();
        isToldTo(RETURN);
        hear(new DroneEvent.ModeReported("RTL", true));
        answers(new Outcome.Succeeded());
        for (int step = 0; step <= 30; step++) {
            isAt(new Geodetic(HERE.latitudeDegrees() + step * 0.01 / 30, HERE.longitudeDegrees()), 20);
            standsStillFor(Duration.ofSeconds(7));
        }
        assertThat(vehicle.performed).containsExactly(RETURN);
        isDown();
        standsStillFor(Duration.ofSeconds(120));

        assertThat(vehicle.performed).containsExactly(RETURN);
        assertThat(control().lapse()).isNull();
    }

    @Test
    void landsWhenItHangsAboveItsHome() {
        isLeft();
        isToldTo(RETURN);
        hear(new DroneEvent.ModeReported("RTL", true));
        answers(new Outcome.Succeeded());
        isAt(FAR, 20);

        standsStillFor(Duration.ofSeconds(62));

        isToldTo(RETURN, LAND);
    }

    @Test
    void landsWhenItRefusesToReturn() {
        isLeft();
        isToldTo(RETURN);
        answers(REFUSED);

        isToldTo(RETURN, LAND);
        assertThat(alarms()).contains("It did not return. It lands where it is.");
    }

    @Test
    void landsWhenItDoesNotKnowWhereItIs() {
        hear(new DroneEvent.GpsReported(new Gps(GpsFix.NONE, 0, null)));
        isLeft();

        isToldTo(LAND);
        assertThat(alarms()).contains("It does not know where it is. It lands where it is.");
    }

    @Test
    void fliesToTheNearestProvedPlaceWhenItsBatteryDoesNotLastForTheWayHome() {
        hear(new DroneEvent.RallyPointsRead(OnboardRallyPoints.of(List.of(new RallyPoint(NEAR, 30)))));
        has(10);
        isLeft();

        Command.GoTo there = new Command.GoTo(NEAR, Altitude.aboveHome(20));
        isToldTo(there);
        answers(new Outcome.Succeeded());
        isAt(new Geodetic(HERE.latitudeDegrees(), HERE.longitudeDegrees() + 0.0003), 20);
        standsStillFor(Duration.ofSeconds(2));
        assertThat(vehicle.performed).containsExactly(there);
        isAt(NEAR, 20);

        isToldTo(there, LAND);
    }

    @Test
    void landsWhereItIsWhenItsBatteryLastsForNoProvedPlace() {
        has(5);
        isLeft();

        isToldTo(LAND);
        assertThat(alarms())
                .anyMatch(text -> text.startsWith("Its battery lasts for about 60 s, and the way home takes"));
    }

    @Test
    void doesNotWaitForAnybodyWhenItsBatteryLastsOnlyJust() {
        has(20);
        awaitTick();
        long left = time.nanos();
        isLeft();

        isToldTo(LAND);
        assertThat(Duration.ofNanos(time.nanos() - left))
                .as("others have a second")
                .isLessThan(RULES.untilReturn());
    }

    @Test
    void landsWhenItRefusesToFlyToThePlace() {
        hear(new DroneEvent.RallyPointsRead(OnboardRallyPoints.of(List.of(new RallyPoint(NEAR, 30)))));
        has(10);
        isLeft();
        Command.GoTo there = new Command.GoTo(NEAR, Altitude.aboveHome(20));
        isToldTo(there);
        long refused = time.nanos();
        answers(REFUSED);

        isToldTo(there, LAND);
        assertThat(Duration.ofNanos(time.nanos() - refused)).isLessThan(Duration.ofSeconds(2));
    }

    @Test
    void landsWhenAZoneIsInItsWayHome() {
        cloud.zones().put(List.of(over(new Geodetic(HERE.latitudeDegrees() + 0.005, HERE.longitudeDegrees()))));
        isLeft();

        isToldTo(LAND);
        assertThat(alarms()).anyMatch(text -> text.contains("“Crowd”"));
    }

    @Test
    void fliesToNoPlaceThatAZoneForbids() {
        hear(new DroneEvent.RallyPointsRead(OnboardRallyPoints.of(List.of(new RallyPoint(NEAR, 30)))));
        cloud.zones().put(List.of(over(NEAR, 20)));
        has(10);
        isLeft();

        isToldTo(LAND);
        assertThat(commands.records.values())
                .as("nor is that tried")
                .noneMatch(record -> record.type().equals("GoTo"));
    }

    @Test
    void callsForHelpWhereAZoneForbidsToLandUntilItFallsOtherwise() {
        cloud.zones().put(List.of(over(HERE)));
        vehicle.performed.clear();
        has(8);
        isLeft();

        until(() -> alarms().stream().anyMatch(text -> text.contains("It does not land here:")));
        assertThat(alarms())
                .anyMatch(text -> text.contains("“Crowd”")
                        && text.endsWith(" Its battery lasts for about 2 min. Take control of it."));
        assertThat(vehicle.performed).doesNotContain(LAND);
        has(4);
        until(() -> vehicle.performed.contains(LAND));
    }

    @Test
    void callsForHelpAllTheSameWhereItsBatteryTellsNothing() {
        hear(new DroneEvent.Identified(
                CloudFixtures.copter(null), new Capabilities(Set.of(Capability.ARM), List.of("GUIDED"), Map.of())));
        isLeft();

        until(() -> alarms().contains(
                        "It is in the air and nobody's. It cannot return by itself. It cannot land by itself."
                                + " How long its battery lasts is not known. Take control of it."));
        standsStillFor(Duration.ofSeconds(62));
        assertThat(alarms()).as("every 30 s").hasSize(3);
    }

    @Test
    void callsForHelpWhenNothingWorksAndTriesAgain() {
        isLeft();
        isToldTo(RETURN);
        answers(REFUSED);
        isToldTo(RETURN, LAND);
        vehicle.performed.clear();
        answers(REFUSED);
        has(60);

        until(() -> alarms().contains("It is in the air and nobody's. It did not return. It did not land."
                + " Its battery lasts for about 12 min. Take control of it."));
        standsStillFor(Duration.ofSeconds(31));
        isToldTo(RETURN);
    }

    @Test
    void isLeftToWhoeverTakesIt() {
        isLeft();
        isToldTo(RETURN);
        apply(new LeaseEvent.TakeControl("bob"));
        answers(REFUSED);

        SteppedUntil.throughout(time, Duration.ofSeconds(5), () -> {
            apply(new LeaseEvent.Heartbeat("bob", control().epoch()));
            return vehicle.performed.size() == 1;
        });
    }

    @Test
    void isLeftToAPilotAndToAnotherStation() {
        isLeft();
        awaitTick();
        hear(new DroneEvent.ModeReported("AUTO", true));

        SteppedUntil.throughout(time, Duration.ofSeconds(60), vehicle.performed::isEmpty);
        assertThat(control().lapse()).isNull();
    }
}
