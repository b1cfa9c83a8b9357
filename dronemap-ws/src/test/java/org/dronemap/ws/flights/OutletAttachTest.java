package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.ws.lab.Administrator;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.GroundStation;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabPeerLink;
import org.dronemap.ws.lab.LabRobot;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.RobotSpec;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.outlet.OutletView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Who gets in at the outlet, and what they see there: two copters that both call themselves system 1. */
class OutletAttachTest {
    private static final Duration SOON = Duration.ofSeconds(10);
    private static final Duration A_WHILE = Duration.ofSeconds(3);

    private final Laboratory lab = new Laboratory(1);
    private final List<LabDrone> twins = List.of(lab.add(VehicleSpec.COPTER, 1), lab.add(VehicleSpec.COPTER, 1));
    private final Administrator administrator = lab.administrator();
    private final Pilot viewer = lab.pilot("eve", Role.VIEWER);

    OutletAttachTest() {
        twins.forEach(lab::ready);
    }

    @AfterEach
    void close() {
        lab.close();
    }

    private GroundStation station(boolean tcp, int systemId) {
        return lab.station(tcp ? LabPeerLink.Kind.TCP : LabPeerLink.Kind.UDP, viewer.passphrase(), systemId);
    }

    private OutletView.RefusedView refused() {
        return administrator.outlet().refused();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void vehiclesOfOneSystemIdAreToldApartAndEveryFrameIsSigned(boolean tcp) {
        GroundStation ground = station(tcp, 255);
        List<Integer> both = ground.hears(twins.size());
        lab.until(
                "both tell where they are",
                SOON,
                () -> both.stream()
                        .allMatch(number ->
                                ground.heard(GlobalPositionInt.ID, number).size() > 5));

        Set<Integer> systems =
                ground.all().stream().map(one -> one.frame().systemId()).collect(Collectors.toSet());
        assertThat(both).containsAll(systems);
        assertThat(ground.all()).allMatch(one -> one.frame().signed());
        assertThat(ground.notItsOwn()).isZero();
        assertThat(both).allMatch(number -> ground.gaps(number) == 0);
        assertThat(both.stream().map(number -> place(ground, number)).toList())
                .containsExactlyInAnyOrderElementsOf(
                        twins.stream().map(twin -> inTruth(twin)).toList());
    }

    /** In steps of 0.0001 degrees. */
    private List<Long> place(GroundStation ground, int number) {
        lab.until(
                "it tells where it is",
                SOON,
                () -> !ground.heard(GlobalPositionInt.ID, number).isEmpty());
        List<GlobalPositionInt> told = ground.heard(GlobalPositionInt.ID, number, GlobalPositionInt::decode);
        GlobalPositionInt last = told.get(told.size() - 1);
        return List.of(Math.round(last.lat() / 1e3), Math.round(last.lon() / 1e3));
    }

    private static List<Long> inTruth(LabDrone drone) {
        return List.of(
                Math.round(drone.place(0, 0).latitudeDegrees() * 1e4),
                Math.round(drone.place(0, 0).longitudeDegrees() * 1e4));
    }

    @Test
    void aUserKnowsEachDroneByTheSameNumberEverAfter() {
        GroundStation first = station(false, 255);
        List<Integer> before = first.hears(twins.size());
        Map<Integer, List<Long>> places = new HashMap<>();
        before.forEach(number -> places.put(number, place(first, number)));
        first.fallsSilent();
        first.line().close();

        GroundStation again = station(true, 254);
        assertThat(again.hears(twins.size())).isEqualTo(before);
        before.forEach(number -> assertThat(place(again, number)).isEqualTo(places.get(number)));
        assertThat(administrator.clients(viewer).stream()
                        .map(OutletView.ClientView::user)
                        .distinct())
                .hasSize(1);

        lab.crashServer();
        lab.startServer();
        GroundStation later = station(true, 253);
        assertThat(later.hears(twins.size())).isEqualTo(before);
        before.forEach(number -> assertThat(place(later, number)).isEqualTo(places.get(number)));
    }

    @Test
    void aClientNeverHasTheNumberOfAVehicle() {
        int taken = station(false, 255).hears(twins.size()).get(0);
        assertThat(station(true, taken).hears(twins.size())).doesNotContain(taken);
    }

    @Test
    void strangersAndWrongPassphrasesSeeNothingAndAreCounted() {
        viewer.passphrase();
        List<GroundStation> strangers = new ArrayList<>();
        for (LabPeerLink.Kind kind : List.of(LabPeerLink.Kind.UDP, LabPeerLink.Kind.TCP)) {
            strangers.add(lab.station(kind, null, 255));
            strangers.add(lab.station(kind, "a passphrase of nobody's " + kind.transport(), 255));
        }
        lab.until("unsigned frames are counted", SOON, () -> refused().unsigned() >= 6);
        lab.until("wrong signatures are counted", SOON, () -> refused().badSignature() >= 6);
        lab.goOn(A_WHILE);
        assertThat(strangers).allMatch(ground -> ground.all().isEmpty() && ground.notItsOwn() == 0);
        assertThat(administrator.clients(viewer)).isEmpty();
    }

    @Test
    void replayedAndOldFramesSeeNothing() {
        GroundStation ground = station(false, 250);
        ground.fallsSilent();
        Instant now = lab.now();
        ground.sends(ground.frame(GroundStation.BEAT, now.minus(Duration.ofMinutes(2))));
        lab.goOn(A_WHILE);
        assertThat(refused().tooOld()).isEqualTo(1);
        assertThat(ground.all()).isEmpty();

        byte[] good = ground.frame(GroundStation.BEAT, now);
        ground.sends(good);
        assertThat(ground.hears(twins.size())).hasSize(2);

        GroundStation thief = station(false, 250);
        thief.fallsSilent();
        for (int number = 0; number < 3; number++) {
            thief.sends(good);
        }
        lab.goOn(A_WHILE);
        assertThat(refused().replayed()).isEqualTo(3);
        assertThat(thief.all()).isEmpty();
        assertThat(administrator.clients(viewer)).hasSize(1);
    }

    @Test
    void aGrantTakenBackSilencesAnAttachedClientWithinASecond() {
        administrator.onlyGranted(viewer);
        GroundStation ground = station(false, 255);
        lab.until("it is attached", SOON, () -> !administrator.clients(viewer).isEmpty());
        lab.until(
                "the cloud says that it is there",
                SOON,
                () -> !ground.heard(Heartbeat.ID, 0).isEmpty());
        assertThat(ground.vehicles()).isEmpty();

        String grant = administrator.grants(viewer, twins.get(0));
        int seen = ground.hears(1).get(0);
        assertThat(place(ground, seen)).isEqualTo(inTruth(twins.get(0)));

        administrator.takesBack(grant);
        Instant taken = lab.now();
        lab.goOn(A_WHILE);
        assertThat(ground.lastHeard(seen)).isBefore(taken.plusSeconds(1));
    }

    @Test
    void aDisabledUserIsSilencedWithinASecondAndStaysOutside() {
        GroundStation ground = station(false, 255);
        List<Integer> seen = ground.hears(twins.size());
        administrator.disables(viewer);
        Instant taken = lab.now();
        lab.until(
                "the client is gone", SOON, () -> administrator.clients(viewer).isEmpty());
        lab.throughout(
                "it stays outside",
                Duration.ofSeconds(10),
                () -> administrator.clients(viewer).isEmpty());
        assertThat(seen).allMatch(number -> ground.lastHeard(number).isBefore(taken.plusSeconds(1)));
        assertThat(refused().turnedAway()).isPositive();
    }

    @Test
    void aClientFollowsToAnotherAddressAndADisconnectedOneStaysOutside() {
        GroundStation first = station(false, 255);
        first.hears(twins.size());
        first.fallsSilent();
        GroundStation moved = station(false, 255);
        moved.hears(twins.size());
        String address = moved.line().address().toString();
        OutletView.ClientView client = administrator.clients(viewer).stream()
                .filter(one -> one.address().equals(address))
                .findFirst()
                .orElseThrow();

        administrator.disconnects(client.id());
        lab.until(
                "it is gone",
                SOON,
                () -> administrator.clients(viewer).stream()
                        .noneMatch(one -> one.id().equals(client.id())));
        int count = moved.all().size();
        lab.goOn(Duration.ofSeconds(20));
        assertThat(moved.all().size()).isLessThanOrEqualTo(count + 1);
        assertThatThrownBy(() -> administrator.disconnects("nobody"))
                .isInstanceOf(Rejection.class)
                .extracting(refused -> ((Rejection) refused).kind())
                .isEqualTo(RejectionKind.UNKNOWN);
    }

    @ParameterizedTest
    @ValueSource(
            longs = {
                1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
                29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54,
                55, 56, 57, 58, 59, 60
            })
    void aClientGetsInFromWhereverItMovesToWhateverGetsLostOrOvertaken(long seed) {
        try (Laboratory bad = new Laboratory(seed)) {
            bad.copter();
            Pilot eve = bad.pilot("eve", Role.VIEWER);
            LabVehicleLink.Quality rough =
                    new LabVehicleLink.Quality(0.3, Duration.ofMillis(50), Duration.ofSeconds(1));
            GroundStation before = bad.station(eve, 255);
            before.line().is(rough);
            before.hears(1);
            for (int times = 0; times < 5; times++) {
                before.fallsSilent();
                before = bad.station(eve, 255);
                before.line().is(rough);
                before.hears(1);
            }
        }
    }

    @Test
    void theSameSeedIsTheSameTalkToTheLastByte() {
        assertThat(talk(7)).isEqualTo(talk(7)).isNotEqualTo(talk(8));
    }

    private static String talk(long seed) {
        try (Laboratory lab = new Laboratory(seed)) {
            LabDrone copter = lab.copter();
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            GroundStation ground = lab.station(ann, 255);
            ground.line().is(new LabVehicleLink.Quality(0.2, Duration.ofMillis(20), Duration.ofMillis(100)));
            LabRobot rover = lab.robot(RobotSpec.rover(3_000)).allows(ann, "hold");
            ann.takesOff(copter, 10);
            rover.does(ann, CommandRequests.hold());
            ground.hears(1);
            return lab.sum();
        }
    }

    @Test
    void anAddressMayBeAnotherUsersProgramsTheNextMoment() {
        GroundStation ground = station(false, 255);
        ground.hears(twins.size());
        Pilot bob = lab.pilot("bob", Role.VIEWER);
        ground.signsWith(bob.passphrase());
        int before = ground.all().size();
        lab.until(
                "his program is attached",
                SOON,
                () -> !administrator.clients(bob).isEmpty());
        lab.goOn(A_WHILE);
        List<Frame> his = ground.all().stream()
                .skip(before)
                .map(GroundStation.Heard::frame)
                .toList();
        assertThat(his).hasSizeGreaterThan(20);
        assertThat(administrator.clients(viewer)).isEmpty();
        assertThat(refused().badSignature()).isZero();
    }

    @Test
    void whoSignsWithTheNewPassphraseIsLetInAtOnceFromTheSameAddress() {
        GroundStation ground = station(false, 255);
        lab.until("it is attached", SOON, () -> !administrator.clients(viewer).isEmpty());
        String before = administrator.clients(viewer).get(0).id();
        ground.signsWith(viewer.choosesPassphrase("correct horse battery"));
        lab.until(
                "it is attached anew",
                Duration.ofSeconds(1),
                () -> administrator.clients(viewer).stream()
                        .anyMatch(client -> !client.id().equals(before)));
        assertThat(ground.hears(twins.size())).hasSize(2);
    }

    @Test
    void anotherPassphraseEndsTheClientsOfTheOneBefore() {
        GroundStation old = station(false, 255);
        old.hears(twins.size());
        assertThat(viewer.choosesPassphrase("correct horse battery")).isEqualTo("correct horse battery");
        lab.until(
                "the client of the old one is gone",
                SOON,
                () -> administrator.clients(viewer).isEmpty());
        station(false, 255).hears(twins.size());

        viewer.clearsPassphrase();
        lab.until("no client is left", SOON, () -> administrator.clients(viewer).isEmpty());
        assertThat(lab.server().accounts().outlet().own(viewer.principal()).passphraseSet())
                .isFalse();
        lab.throughout(
                "nobody comes back",
                A_WHILE,
                () -> administrator.clients(viewer).isEmpty());
    }
}
