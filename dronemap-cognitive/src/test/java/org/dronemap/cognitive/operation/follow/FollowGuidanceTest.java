package org.dronemap.cognitive.operation.follow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.cognitive.follow.StandOffSide;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.operation.AirspaceSnapshot;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneValidity;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What a follow's drone is told, with what comes to be around it meanwhile; it does as it is told at once. */
class FollowGuidanceTest {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    private static final DroneId FALCON = new DroneId("d1");
    private static final Geodetic HOME = new Geodetic(47.3977, 8.5456);
    /** 60 m north of there. */
    private static final Geodetic PHONE = new Geodetic(47.39824, 8.5456);

    private static final double AMSL = 503;

    private final FollowState state = FollowState.begin(
                    new OperationId("follow-1"),
                    new FollowOrder(
                            new ChosenDrone(FALCON, "Falcon", HOME, 488, "Falcon was chosen."),
                            PHONE,
                            new FollowOrder.RelativePlace(new StandOffSide.Fixed(0), 0, 15),
                            12,
                            60),
                    ZERO)
            .to(FollowStage.TRACKING, ZERO, "It follows.");
    private FollowGuidance guide = new FollowGuidance(state.order().near(), Separation.USUAL);
    private Geodetic falcon = HOME;
    private List<Zone> zones = List.of();
    private List<DroneState> aloft = List.of();
    private int tenths;
    private @Nullable Double gaze;

    private static final OperationObservation.ControlStatus OURS =
            new OperationObservation.ControlStatus(null, null, false, null);

    private static DroneState drone(String id, Geodetic point, Instant at) {
        return drone(id, point, AMSL, at);
    }

    private static DroneState drone(String id, Geodetic point, double amsl, Instant at) {
        LinkStatus link = new LinkStatus(
                new DroneKey("127.0.0.1", 1, 1), "udp", LinkState.LIVE, at, LinkQuality.UNKNOWN, List.of());
        return new DroneState(
                new DroneId(id),
                id,
                false,
                link,
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", null, null),
                IdentityTrust.UNPROVED,
                new Capabilities(Set.of(), List.of("GUIDED"), Map.of("GUIDED", Capabilities.Steering.ORDERS)),
                "GUIDED",
                true,
                true,
                FlightPhase.IN_AIR,
                new Position(point, amsl, amsl - 488),
                null,
                null,
                null,
                new Battery(90, null, null),
                null,
                new Home(HOME, 488),
                null,
                PayloadState.UNKNOWN,
                MissionProgress.UNKNOWN,
                List.of(),
                at,
                0,
                null);
    }

    private static Zone circle(Geodetic center, double meters) {
        return zone(new FenceArea.Circle(false, center, meters), AltitudeBand.ALL);
    }

    private static Zone zone(FenceArea shape, AltitudeBand band) {
        return new Zone(
                "z1",
                "the stage",
                shape,
                band,
                ZoneBinding.EVERYBODY,
                ZoneValidity.ALWAYS,
                BreachAction.HOLD,
                "ann",
                ZERO);
    }

    @Test
    void takesAPlaceThatIsKnownToMoreThanFiftyMetresForNone() {
        assertThat(guide.reported(new TargetReport(1, ZERO, ZERO, ZERO, null, PHONE, 51, null)))
                .isFalse();
        assertThat(guide.reported(new TargetReport(2, ZERO, ZERO, ZERO, null, PHONE, 50, null)))
                .isTrue();
    }

    /** For so long; the nearest that it came to a place. */
    private double led(double seconds, Geodetic place) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int end = tenths + (int) (seconds * 10); tenths < end; tenths++) {
            Instant now = ZERO.plus(Duration.ofMillis(100L * tenths));
            guide.reported(new TargetReport(tenths, now, now, now, Duration.ZERO, PHONE, 3, null));
            OperationObservation.ObservedDrone seen = new OperationObservation.ObservedDrone(
                    drone("d1", falcon, now), OURS, Duration.ZERO, Duration.ZERO);
            AirspaceSnapshot around = new AirspaceSnapshot(Map.of(FALCON, zones), aloft, List.of(), Set.of());
            OperationObservation scene = new OperationObservation(now, List.of(seen), now, null, around, Map.of());
            Setpoint.Track said = (Setpoint.Track) guide.steer(state, scene).get(FALCON);
            falcon = said.point();
            gaze = said.cameraElevationDegrees();
            nearest = Math.min(nearest, Geodesy.distanceMeters(falcon, place));
        }
        return nearest;
    }

    @Test
    void heedsAZoneThatAppearsOnItsWay() {
        led(4, PHONE);
        double before = Geodesy.distanceMeters(falcon, PHONE);
        assertThat(before).isBetween(35.0, 58.0);
        zones = List.of(circle(PHONE, 15));
        assertThat(led(40, PHONE)).isGreaterThan(19.5).isLessThan(25);
        zones = List.of();
        assertThat(led(30, PHONE)).isLessThan(1);
    }

    @Test
    void keepsApartFromADroneThatStandsWhereItWouldBe() {
        aloft = List.of(drone("d2", PHONE, ZERO));
        assertThat(led(40, PHONE)).isBetween(13.0, 18.0);
        aloft = List.of();
        assertThat(led(30, PHONE)).isLessThan(1);
    }

    private static OperationObservation both(Geodetic kestrel, double amsl) {
        return new OperationObservation(
                ZERO,
                List.of(
                        new OperationObservation.ObservedDrone(
                                drone("d1", HOME, ZERO), OURS, Duration.ZERO, Duration.ZERO),
                        new OperationObservation.ObservedDrone(
                                drone("d2", kestrel, amsl, ZERO), OURS, Duration.ZERO, Duration.ZERO)));
    }

    @Test
    void isNotThereForTheOtherOneBeforeItHasRisen() {
        ChosenDrone kestrel = new ChosenDrone(new DroneId("d2"), "Kestrel", PHONE, 488, "It was chosen.");
        FollowOperation follow = new FollowOperation(Separation.USUAL);
        FollowState relieved =
                follow.decide(state, new FollowInput.SendRelief(ZERO, kestrel)).next();
        FollowInput.Observed low = (FollowInput.Observed) follow.observed(relieved, both(PHONE, 490));
        assertThat(low.others()).extracting(FollowInput.OtherDrone::apartMeters).containsOnlyNulls();
        FollowInput.Observed up = (FollowInput.Observed) follow.observed(relieved, both(PHONE, AMSL));
        assertThat(up.others().get(0).apartMeters()).isCloseTo(Geodesy.distanceMeters(HOME, PHONE), within(0.01));
    }

    @Test
    void leadsTheOtherOneToWhereBothHaveRoom() {
        assertThat(waitingHeight()).as("above all that follow").isCloseTo(15 + 16, within(0.1));
    }

    @Test
    void leadsTheOtherOneNoHigherThanTheZonesThatItStaysIn() {
        AltitudeBand low = new AltitudeBand(null, 25.0, Altitude.Reference.HOME);
        zones = List.of(zone(new FenceArea.Circle(true, PHONE, 500), low));
        assertThat(waitingHeight()).isCloseTo(25 - 2, within(0.1));
        zones = List.of(
                zone(new FenceArea.Circle(true, PHONE, 500), new AltitudeBand(null, 510.0, Altitude.Reference.AMSL)));
        assertThat(waitingHeight()).isCloseTo(22 - 2, within(0.1));
    }

    /** Metres above its home. */
    private double waitingHeight() {
        guide = new FollowGuidance(state.order().near(), Separation.USUAL);
        ChosenDrone kestrel = new ChosenDrone(new DroneId("d2"), "Kestrel", HOME, 488, "It was chosen.");
        FollowState relieved = new FollowOperation(Separation.USUAL)
                .decide(state, new FollowInput.SendRelief(ZERO, kestrel))
                .next();
        FollowState rising = relieved.reliefOrNone().others().get(0);
        FollowState both = relieved.with(
                relieved.reliefOrNone().with(List.of(rising.to(FollowStage.TRACKING, ZERO, "It is in the air."))));
        Geodetic first = PHONE;
        Geodetic second = new Geodetic(47.39870, 8.5456);
        double least = Double.POSITIVE_INFINITY;
        Map<DroneId, Setpoint> said = Map.of();
        for (int tenth = 0; tenth < 400; tenth++) {
            Instant now = ZERO.plusMillis(100L * tenth);
            guide.reported(new TargetReport(tenth, now, now, now, Duration.ZERO, PHONE, 3, null));
            List<OperationObservation.ObservedDrone> seen = List.of(
                    new OperationObservation.ObservedDrone(drone("d1", first, now), OURS, Duration.ZERO, Duration.ZERO),
                    new OperationObservation.ObservedDrone(
                            drone("d2", second, now), OURS, Duration.ZERO, Duration.ZERO));
            said = guide.steer(
                    both,
                    new OperationObservation(
                            now,
                            seen,
                            now,
                            null,
                            new AirspaceSnapshot(Map.of(new DroneId("d2"), zones), List.of(), List.of(), said.keySet()),
                            Map.of()));
            first = ((Setpoint.Track) said.get(FALCON)).point();
            second = ((Setpoint.Track) said.get(new DroneId("d2"))).point();
            least = Math.min(least, Geodesy.distanceMeters(first, second));
        }
        assertThat(least).isGreaterThan(13.5);
        assertThat(Geodesy.distanceMeters(first, PHONE)).isLessThan(1);
        assertThat(Geodesy.distanceMeters(second, PHONE)).isBetween(15.0, 17.0);
        return ((Setpoint.Track) said.get(new DroneId("d2"))).altitude().meters() - 488;
    }

    /** By one that waited 20 m away; it has flown beside its home. */
    private FollowState replaced() {
        FollowOperation follow = new FollowOperation(Separation.USUAL);
        ChosenDrone kestrel = new ChosenDrone(new DroneId("d2"), "Kestrel", PHONE, 488, "It was chosen.");
        FollowState relieved =
                follow.decide(state, new FollowInput.SendRelief(ZERO, kestrel)).next();
        FollowState up = relieved.reliefOrNone().others().get(0).to(FollowStage.TRACKING, ZERO, "It is in the air.");
        FollowState ready = relieved.with(relieved.reliefOrNone().with(List.of(up)));
        falcon = new Geodetic(HOME.latitudeDegrees() + 0.0006, HOME.longitudeDegrees());
        FollowInput.Observation air = FollowTestBase.led(
                new FollowInput.Observation(null, 0, true, true, true, false, "GUIDED", 90, 66.0, null, null));
        FollowState after = follow.decide(
                        ready,
                        new FollowInput.Observed(
                                ZERO,
                                air,
                                ZERO,
                                null,
                                null,
                                List.of(new FollowInput.OtherDrone(kestrel.drone(), air, 20.0))))
                .next();
        assertThat(after.drone()).isEqualTo(kestrel.drone());
        return after;
    }

    @Test
    void leadsHomeWhoWasReplacedAndKeepsItApart() {
        FollowState after = replaced();
        Geodetic inTheWay = new Geodetic(HOME.latitudeDegrees() + 0.0003, HOME.longitudeDegrees());
        double nearest = Double.POSITIVE_INFINITY;
        double highest = 0;
        Setpoint said = null;
        for (int tenth = 0; tenth < 580; tenth++) {
            Instant now = ZERO.plusMillis(100L * tenth);
            DroneState old = drone("d1", falcon, now);
            AirspaceSnapshot around =
                    new AirspaceSnapshot(Map.of(), List.of(drone("d3", inTheWay, now)), List.of(), Set.of());
            List<OperationObservation.ObservedDrone> seen =
                    List.of(new OperationObservation.ObservedDrone(old, OURS, Duration.ZERO, Duration.ZERO));
            said = guide.steer(after, new OperationObservation(now, seen, now, null, around, Map.of()))
                    .get(FALCON);
            if (said == null) {
                break;
            }
            falcon = ((Setpoint.Track) said).point();
            highest = ((Setpoint.Track) said).altitude().meters();
            if (highest - AMSL < Separation.USUAL.verticalMeters()) {
                nearest = Math.min(nearest, Geodesy.distanceMeters(falcon, inTheWay));
            }
        }
        assertThat(highest)
                .as("above those that come, who are above all that follow")
                .isGreaterThan(488 + 15 + 16);
        assertThat(said).as("the last metres it flies by itself").isNull();
        assertThat(Geodesy.distanceMeters(falcon, HOME)).isBetween(13.0, 15.0);
        assertThat(nearest).isGreaterThan(12);
    }

    @Test
    void hasTheCameraLookAtWhoIsFollowed() {
        led(0.2, PHONE);
        double away = Geodesy.distanceMeters(HOME, PHONE);
        assertThat(gaze).isCloseTo(-Math.toDegrees(Math.atan2(AMSL - 488 - 1.5, away)), within(0.5));
        led(40, PHONE);
        assertThat(gaze).as("right above").isLessThan(-85);
    }

    @Test
    void keepsAsFarApartAsIsSet() {
        guide = new FollowGuidance(state.order().near(), new Separation(25, 5));
        aloft = List.of(drone("d2", PHONE, ZERO));
        assertThat(led(60, PHONE)).isBetween(28.0, 33.0);
    }
}
