package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.follow.FollowRequest.PlaceRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.FadingLink;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.LabVehicleLink.Quality;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SimulatedPhone;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.lab.ZoneFixtures;
import org.dronemap.ws.link.DtlsKeyService.DtlsKeyRequest;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.virtual.VirtualDroneRequest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is done before a link is lost that fades, and that nothing is done while a link is as it usually is. */
class FadingLinkTest {
    private static final long AUTO = 3;
    private static final long GUIDED = 4;
    private static final long RTL = 6;
    private static final int FADE_SECONDS = 60;
    private static final int FIRST_SEED = 1_001;
    private static final Duration USUAL = Duration.ofSeconds(90);
    private static final Duration FLIGHT = Duration.ofMinutes(4);
    private static final List<Quality> NORMALS = List.of(
            Quality.GOOD,
            new Quality(0, Duration.ofMillis(5), Duration.ofMillis(400)),
            new Quality(0.1, Duration.ofMillis(20), Duration.ofMillis(20)));

    /** On a long way, which nobody has in hand. */
    private static LabDrone flies(Laboratory lab) {
        LabDrone drone = lab.copter();
        lab.pilot("ann", Role.OPERATOR)
                .plans(drone, 30, drone.place(3_000, 0), drone.place(0, 0))
                .startsMission(drone);
        return drone;
    }

    private static boolean acted(LabDrone drone) {
        boolean told = Stream.of("It climbs", "It comes home", "It slows down").anyMatch(drone::isTold);
        return told && drone.mode() != AUTO;
    }

    /** Thresholds were chosen on other seeds. */
    private static int actedInTime(int seeds) {
        int acted = 0;
        for (int seed = FIRST_SEED; seed < FIRST_SEED + seeds; seed++) {
            try (Laboratory lab = new Laboratory(seed)) {
                LabDrone drone = flies(lab);
                FadingLink link = new FadingLink(lab, drone.wire(), NORMALS.get(seed % NORMALS.size()), seed);
                lab.goOn(USUAL);
                boolean[] lost = {false};
                boolean inTime = link.fades(FADE_SECONDS, () -> {
                    lost[0] |= drone.isLost();
                    return !lost[0] && acted(drone);
                });
                acted += inTime ? 1 : 0;
            }
        }
        return acted;
    }

    /** Judged by each moment of the flight: an act that is over at its end was one too many. */
    private static void nothingIsDone(int seeds) {
        for (int seed = FIRST_SEED; seed < FIRST_SEED + seeds; seed++) {
            for (Quality normal : NORMALS) {
                try (Laboratory lab = new Laboratory(seed)) {
                    LabDrone drone = flies(lab);
                    drone.wire().is(normal);
                    lab.throughout(
                            "nothing is done, seed " + seed + ", " + normal,
                            FLIGHT,
                            () -> drone.mode() == AUTO && !drone.isTold("Its link g"));
                }
            }
        }
    }

    @Test
    void actsBeforeTheLinkIsLost() {
        assertThat(actedInTime(10)).isEqualTo(10);
    }

    @Test
    void doesNothingWhileTheLinkIsAsItUsuallyIs() {
        nothingIsDone(3);
    }

    @Test
    @Tag("soak")
    void actsBeforeTheLinkIsLostForAHundredSeeds() {
        assertThat(actedInTime(100)).isGreaterThanOrEqualTo(95);
    }

    @Test
    @Tag("soak")
    void doesNothingWhileTheLinkIsAsItUsuallyIsForAHundredSeeds() {
        nothingIsDone(100);
    }

    @Test
    void climbsAndGoesOnWhenThatHelps() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone drone = flies(lab);
            FadingLink link = new FadingLink(lab, drone.wire(), Quality.GOOD, 1);
            lab.goOn(USUAL);
            assertThat(link.fades(FADE_SECONDS, () -> drone.isTold("It climbs")))
                    .isTrue();
            lab.until("it has risen", Duration.ofSeconds(30), () -> drone.mode() == GUIDED && drone.height() > 40);

            link.recovers();

            lab.until("it goes on", Duration.ofSeconds(90), () -> drone.mode() == AUTO);
            assertThat(drone.isTold("Its link is as usual again since it has climbed"))
                    .isTrue();
        }
    }

    @Test
    void isToldOnceMoreWhatItDidNotReceive() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone drone = lab.copter();
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            ann.plans(drone, 30, drone.place(3_000, 0), drone.place(0, 0))
                    .does(drone, CommandRequests.arm())
                    .does(drone, CommandRequests.startMission("continue"));
            FadingLink link = new FadingLink(lab, drone.wire(), Quality.GOOD, 1);
            lab.goOn(USUAL);
            assertThat(link.fades(FADE_SECONDS, () -> {
                        drone.vehicle().setDeaf(drone.state().link().trend().state() != LinkTrend.State.STEADY);
                        return drone.isTold("It climbs");
                    }))
                    .as(drone.words())
                    .isTrue();
            lab.until(
                    "the command is given up",
                    Duration.ofSeconds(20),
                    () -> ann.commandsOf(drone).stream()
                            .anyMatch(command -> command.type().equals("goTo") && command.outcome() != null));
            assertThat(drone.mode()).isEqualTo(AUTO);

            drone.vehicle().setDeaf(false);

            lab.until("it climbs", Duration.ofSeconds(12), () -> drone.mode() == GUIDED && drone.height() > 33);
        }
    }

    @ParameterizedTest
    @CsvSource({"continue, 3", "rtl, 6"})
    void doesWithoutTheCloudWhatItsOwnerChoseAfterItHasClimbedToo(String onCloudLoss, long mode) {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone drone = lab.copter();
            lab.pilot("ann", Role.OPERATOR)
                    .plans(drone, 30, drone.place(3_000, 0), drone.place(0, 0))
                    .does(drone, CommandRequests.arm())
                    .does(drone, CommandRequests.startMission(onCloudLoss));
            FadingLink link = new FadingLink(lab, drone.wire(), Quality.GOOD, 1);
            lab.goOn(USUAL);
            assertThat(link.fades(FADE_SECONDS, () -> drone.isTold("It climbs")))
                    .isTrue();
            lab.until("it has risen", Duration.ofSeconds(30), () -> drone.mode() == GUIDED && drone.height() > 40);
            link.recovers();
            lab.until("it goes on", Duration.ofSeconds(90), () -> drone.mode() == AUTO);
            lab.goOn(Duration.ofSeconds(5));

            drone.wire().cut();
            lab.goOn(Duration.ofSeconds(60));

            assertThat(drone.mode()).isEqualTo(mode);
        }
    }

    @Test
    void comesHomeWhenThatDoesNotHelp() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone drone = flies(lab);
            FadingLink link = new FadingLink(lab, drone.wire(), Quality.GOOD, 1);
            lab.goOn(USUAL);
            assertThat(link.fades(FADE_SECONDS, () -> !drone.isLost() && drone.mode() == RTL))
                    .isTrue();
            assertThat(drone.isTold("It has climbed, which did not help; it comes home."))
                    .isTrue();
        }
    }

    @Test
    void doesNotClimbIntoAZone() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone drone = flies(lab);
            FadingLink link = new FadingLink(lab, drone.wire(), Quality.GOOD, 1);
            lab.goOn(USUAL);
            Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
            var unused =
                    lab.server().zones().add(chief.principal(), ZoneFixtures.box(drone, -100, 4_000, 200, null, 45.0));
            assertThat(link.fades(FADE_SECONDS, () -> drone.isTold("Its link gets worse")))
                    .isTrue();
            assertThat(drone.isTold("It slows down")).isTrue();
        }
    }

    @Test
    void whoHasItInHandIsWarnedAndItIsNotTakenFromThem() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone drone = lab.copter();
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            ann.takesOff(drone, 20);
            FadingLink link = new FadingLink(lab, drone.wire(), Quality.GOOD, 1);
            for (int i = 0; i < 9; i++) {
                lab.goOn(Duration.ofSeconds(10));
                Geodetic next = drone.place(20 * i, 0);
                ann.fliesTo(drone, next, 20);
            }
            assertThat(link.fades(25, () -> drone.isTold("Let it return home"))).isTrue();
            assertThat(drone.mode()).isEqualTo(GUIDED);
        }
    }

    /** One of two fades until nothing comes: the drone is reached by the other one. */
    private static void nothingIsDoneOnTwoLinks(int seeds) {
        for (int seed = 1; seed <= seeds; seed++) {
            try (Laboratory lab = new Laboratory(seed)) {
                LabDrone drone = lab.add(VehicleSpec.COPTER.insisting());
                Pilot ada = lab.pilot("ada", Role.ADMINISTRATOR);
                String identity = lab.server()
                        .office()
                        .dtlsKeys()
                        .make(ada.principal(), new DtlsKeyRequest("copter on two links", null))
                        .identity();
                drone.wire().is(LabVehicleLink.Kind.dtls(identity));
                drone.addWire(LabVehicleLink.Kind.dtls(identity)).is(NORMALS.get(seed % NORMALS.size()));
                lab.ready(drone);
                ada.plans(drone, 30, drone.place(3_000, 0), drone.place(0, 0)).startsMission(drone);
                FadingLink link = new FadingLink(lab, drone.wire(), Quality.GOOD, seed);
                lab.goOn(USUAL);
                assertThat(link.fades(FADE_SECONDS, drone::isLost)).isFalse();
                lab.goOn(Duration.ofSeconds(20));
                assertThat(drone.isTold("It climbs")).as("seed %d", seed).isFalse();
                assertThat(drone.mode()).isEqualTo(AUTO);
            }
        }
    }

    @Test
    void doesNothingWhereAnotherLinkIsLeft() {
        nothingIsDoneOnTwoLinks(4);
    }

    @Test
    @Tag("soak")
    void doesNothingWhereAnotherLinkIsLeftForAHundredSeeds() {
        nothingIsDoneOnTwoLinks(100);
    }

    @Test
    void othersFlyTheWaypointsOfARunsDroneWhoseLinkFades() {
        try (Laboratory lab = new Laboratory(1)) {
            List<LabDrone> drones = lab.copters(2);
            LabDrone first = drones.get(0);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            MissionRunFlight run = MissionRunFlight.begins(
                    lab,
                    ann,
                    drones,
                    Stream.of(100, 300, 500, 700)
                            .flatMap(north ->
                                    drones.stream().map(drone -> MissionRunFlight.waypoint(drone.place(north, 0), 540)))
                            .toList(),
                    MissionRunFlight.Manner.ON);
            run.awaitsAll("flying");
            FadingLink link = new FadingLink(lab, first.wire(), Quality.GOOD, 1);
            lab.goOn(Duration.ofSeconds(40));

            assertThat(link.fades(FADE_SECONDS, () -> !first.isLost() && first.mode() == RTL))
                    .isTrue();

            assertThat(run.told("linkFalling")).isNotEmpty();
            assertThat(run.end().waypoints())
                    .allMatch(waypoint -> waypoint.state().equals("visited"));
            assertThat(run.decidesTheSameAgain()).isTrue();
        }
    }

    @Test
    void anotherDroneFliesOnWithTheMissionOfAVirtualDrone() {
        try (Laboratory lab = new Laboratory(1)) {
            List<LabDrone> drones = lab.copters(2);
            Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
            drones.forEach(one ->
                    lab.server().warehouse().put(chief.principal(), one.id().value()));
            Geodetic far = drones.get(0).place(1_200, 0);
            String virtual = lab.server()
                    .virtuals()
                    .add(
                            chief.principal(),
                            new VirtualDroneRequest(
                                    "Survey",
                                    null,
                                    MissionItemRequest.of(
                                            List.of(new MissionItem.Waypoint(far, Altitude.aboveHome(30), 0))),
                                    null))
                    .id();
            lab.server().virtuals().start(chief.principal(), virtual, null);
            lab.until("it flies", Duration.ofMinutes(2), () -> drones.stream().anyMatch(one -> one.mode() == AUTO));
            LabDrone first = drones.stream()
                    .filter(one -> one.mode() == AUTO)
                    .findFirst()
                    .orElseThrow();
            LabDrone other = drones.get(1 - drones.indexOf(first));
            FadingLink link = new FadingLink(lab, first.wire(), Quality.GOOD, 1);
            lab.goOn(Duration.ofSeconds(30));

            assertThat(link.fades(FADE_SECONDS, () -> !first.isLost() && first.mode() == RTL))
                    .isTrue();

            lab.until("another one comes to the place", Duration.ofMinutes(8), () -> other.distanceTo(far) < 5);
            assertThat(first.distanceTo(far)).isGreaterThan(200);
        }
    }

    @Test
    void aDroneThatFollowsFliesHomeAndAnotherOneComes() {
        try (Laboratory lab = new Laboratory(1)) {
            List<LabDrone> drones = lab.copters(2);
            Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
            drones.forEach(one ->
                    lab.server().warehouse().put(chief.principal(), one.id().value()));
            LabDrone first = drones.get(0);
            SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), first, 150, 0);
            phone.asks(first, new PlaceRequest("fixed", 180.0, null, 10.0, 15.0), 60)
                    .starts();
            phone.awaits("tracking", Duration.ofMinutes(2));
            FadingLink link = new FadingLink(lab, first.wire(), Quality.GOOD, 1);
            lab.goOn(Duration.ofSeconds(60));

            assertThat(link.fades(FADE_SECONDS, () -> !first.isLost() && first.mode() == RTL))
                    .isTrue();
            assertThat(phone.wasTold("flies home before its link is lost")).isTrue();

            link.recovers();
            LabDrone other = drones.get(1);
            lab.until("another one has come", Duration.ofMinutes(3), () -> other.distanceTo(phone.place()) < 15);
            lab.until("the first one is down at home", Duration.ofMinutes(3), () -> first.isDown() && first.away() < 3);
        }
    }
}
