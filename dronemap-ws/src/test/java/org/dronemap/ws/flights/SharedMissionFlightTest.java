package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.virtual.VirtualDroneRequest;
import org.dronemap.ws.virtual.VirtualDroneView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A virtual drone's mission that up to three drones of the pool share. */
class SharedMissionFlightTest {
    private static final double HEIGHT = 20;
    private static final int WAYPOINTS = 9;
    private static final long RTL = 6;
    private static final double SERVED_METERS = 2;
    /** Of the 20 while it waits. */
    private static final int FIXES_OF_WAITING = 18;

    private static final Duration SOON = Duration.ofSeconds(20);
    private static final Duration TAKE_OFF = Duration.ofMinutes(3);
    private static final Duration WHOLE = Duration.ofMinutes(20);

    private final Laboratory lab = new Laboratory(1);
    private final List<LabDrone> copters = lab.copters(4);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    /** Three rows, one behind the other. */
    private List<Geodetic> places() {
        LabDrone first = copters.get(0);
        return IntStream.range(0, WAYPOINTS)
                .mapToObj(n -> first.place(-60 - 40 * (n % 3), 60 * Math.floorDiv(n, 3)))
                .toList();
    }

    private String planned(Integer upTo) {
        return planned(upTo, places());
    }

    private String planned(Integer upTo, List<Geodetic> places) {
        List<MissionItem> items = places.stream()
                .<MissionItem>map(place -> new MissionItem.Waypoint(place, Altitude.aboveHome(HEIGHT), 2))
                .toList();
        return lab.server()
                .virtuals()
                .add(chief.principal(), new VirtualDroneRequest("Survey", null, MissionItemRequest.of(items), upTo))
                .id();
    }

    private String begun(int upTo, int lent) {
        return begun(planned(upTo), lent);
    }

    private String begun(String virtual, int lent) {
        copters.subList(0, lent)
                .forEach(drone -> lab.server()
                        .warehouse()
                        .put(chief.principal(), drone.id().value()));
        lab.server().virtuals().start(chief.principal(), virtual, null);
        return virtual;
    }

    private VirtualDroneView.RunView run(String virtual) {
        return Objects.requireNonNull(
                lab.server().virtuals().one(chief.principal(), virtual).run());
    }

    /** The real drones that serve it now. */
    private List<LabDrone> serving(String virtual) {
        Set<String> ids = run(virtual).shares().stream()
                .filter(share -> share.drone() != null)
                .map(share -> share.drone().id())
                .collect(Collectors.toSet());
        return copters.stream().filter(one -> ids.contains(one.id().value())).toList();
    }

    private boolean areBound(String virtual, Integer drones) {
        return drones.equals(run(virtual).drones());
    }

    private boolean allFly(String virtual) {
        return run(virtual).shares().stream().allMatch(share -> share.state().equals("flying"));
    }

    private void awaitsDone(String virtual) {
        awaitsDone(virtual, WAYPOINTS);
    }

    private void awaitsDone(String virtual, int waypoints) {
        lab.untilSeen("it is done", WHOLE, () -> run(virtual).state().equals("done"));
        assertThat(run(virtual).flown()).isEqualTo(waypoints);
        lab.until(
                "all are down",
                TAKE_OFF,
                () -> copters.stream()
                        .allMatch(drone -> drone.isDown() || drone.craft().crashed()));
    }

    /** The drones that waited there; others may pass on their way. */
    private List<LabDrone> servedBy(Geodetic place) {
        return copters.stream()
                .filter(drone -> drone.track().since(0).stream()
                                .filter(fix -> fix.metersTo(place, drone.groundAmsl() + HEIGHT) < SERVED_METERS)
                                .count()
                        > FIXES_OF_WAITING)
                .toList();
    }

    @Test
    void threeDronesShareItAndEachWaypointIsServedOnce() {
        Separation separation = new Separation(copters);
        String virtual = begun(3, 4);
        lab.untilSeen("three are bound", SOON, () -> areBound(virtual, 3));
        assertThat(run(virtual).shares())
                .extracting(VirtualDroneView.ShareView::total)
                .hasSize(3)
                .allMatch(total -> total >= 2);
        assertThat(run(virtual).drone()).isNull();
        lab.throughout("they keep apart", Duration.ofMinutes(5), () -> {
            separation.look();
            return separation.least() >= 1 || separation.least() == Double.POSITIVE_INFINITY;
        });
        awaitsDone(virtual);
        assertThat(places()).allSatisfy(place -> assertThat(servedBy(place)).hasSize(1));
        assertThat(places().stream().map(this::servedBy).distinct()).hasSize(3);
        assertThat(run(virtual).sentence()).isEqualTo("Done: all waypoints are flown, in 3 shares.");
    }

    @Test
    void oneDroneFliesAllOfItWhenNoOtherIsFree() {
        String virtual = begun(3, 1);
        awaitsDone(virtual);
        assertThat(run(virtual).shares()).hasSize(1);
        assertThat(places()).allSatisfy(place -> assertThat(servedBy(place)).containsExactly(copters.get(0)));
    }

    @Test
    void aDroneThatIsLostAtTakeOffIsReplacedByAnother() {
        String virtual = begun(3, 4);
        LabDrone lost = lab.until(
                "one takes off",
                TAKE_OFF,
                () -> serving(virtual).stream()
                        .filter(drone -> drone.height() > 1)
                        .findFirst());
        lost.craft().failMotor();
        awaitsDone(virtual);
        assertThat(places())
                .allSatisfy(place -> assertThat(servedBy(place)).isNotEmpty().doesNotContain(lost));
        assertThat(lost.craft().crashed()).isTrue();
    }

    @Test
    void theServerThatFollowsGoesOnWithAllShares() {
        String virtual = begun(3, 3);
        lab.untilSeen("all fly", TAKE_OFF, () -> areBound(virtual, 3) && allFly(virtual));
        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer();
        assertThat(run(virtual).drones()).isEqualTo(3);
        awaitsDone(virtual);
        assertThat(places()).allSatisfy(place -> assertThat(servedBy(place)).hasSize(1));
    }

    @Test
    void stoppingCallsAllHome() {
        String virtual = begun(3, 3);
        lab.untilSeen("all fly", TAKE_OFF, () -> areBound(virtual, 3) && allFly(virtual));
        List<LabDrone> serving = serving(virtual);
        lab.server().virtuals().stop(chief.principal(), virtual);
        lab.until("all turn home", SOON, () -> serving.stream().allMatch(drone -> drone.mode() == RTL));
        lab.untilSeen("it is stopped", TAKE_OFF, () -> run(virtual).state().equals("stopped"));
        assertThat(copters).allMatch(drone -> drone.isDown() && drone.away() < 3);
        assertThat(run(virtual).sentence()).startsWith("It was stopped: ");
    }

    @Test
    void whoCallsOneDroneHomeSuspendsItsShareAloneAndResumingGoesOnWithIt() {
        String virtual = begun(3, 3);
        lab.untilSeen("all fly", TAKE_OFF, () -> areBound(virtual, 3) && allFly(virtual));
        LabDrone taken = serving(virtual).get(0);
        Pilot ann = lab.pilot("ann", Role.SUPERVISOR);
        ann.does(taken, CommandRequests.returnToLaunch());
        lab.untilSeen("its share waits", SOON, () -> run(virtual).sentence().contains("1 suspended"));
        lab.throughout("two go on", SOON, () -> areBound(virtual, 2));
        lab.server().virtuals().resume(chief.principal(), virtual);
        awaitsDone(virtual);
        assertThat(places()).allSatisfy(place -> assertThat(servedBy(place)).isNotEmpty());
    }

    /** No plan keeps their shares apart, so their whole flights are compared before they begin, as strangers' are. */
    @Test
    void oneWaitsOnTheGroundWhoseShareWouldMeetAnothers() {
        LabDrone first = copters.get(0);
        String virtual = planned(
                2, List.of(first.place(-60, 0), first.place(-60, 150), first.place(-60, 155), first.place(-60, 5)));
        begun(virtual, 2);
        lab.untilSeen("two are bound", SOON, () -> areBound(virtual, 2));
        lab.until(
                "one waits on the ground",
                SOON,
                () -> run(virtual).shares().stream()
                        .anyMatch(share -> share.sentence().contains("waits on the ground")));
        awaitsDone(virtual, 4);
    }

    @Test
    void aNumberOfDronesOutOfRangeIsRefused() {
        for (int upTo : new int[] {0, 9}) {
            Rejection refused = catchThrowableOfType(Rejection.class, () -> planned(upTo));
            assertThat(refused.sentence()).contains("upTo", "1 to 8 drones");
        }
    }
}
