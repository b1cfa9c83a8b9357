package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.LinkState;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.fence.FenceService;
import org.dronemap.ws.fence.FenceView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.DirectGroundStation;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTap;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.problem.InvalidInput;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Missions over links that are bad, or break: what the vehicle holds is what was sent, or it is said. */
class OnBoardMissionsTest {
    private static final String AUTOPILOTS = "org.dronemap.ws.lab.VehicleSpec#autopilots";
    private static final Duration FELT = Duration.ofSeconds(10);
    private static final int ENDED = 10_000;

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private record Place(int x, int y, long z) {
        static Place of(MissionItemRequest.Waypoint item) {
            return new Place(
                    (int) Math.round(Objects.requireNonNull(item.latitude()) * 1e7),
                    (int) Math.round(Objects.requireNonNull(item.longitude()) * 1e7),
                    Math.round(Objects.requireNonNull(item.altitude())));
        }
    }

    private static MissionItemRequest.Waypoint waypoint(double latitude, double longitude, double altitude) {
        return new MissionItemRequest.Waypoint(latitude, longitude, altitude, null, null);
    }

    private static List<MissionItemRequest.Waypoint> waypoints(int count, int other) {
        return IntStream.range(0, count)
                .mapToObj(number -> waypoint(
                        Math.rint((47.3977 + (number + 1 + other) * 1e-5) * 1e7) / 1e7,
                        Math.rint((8.5456 + (number % 7) * 2e-5) * 1e7) / 1e7,
                        20 + number % 30))
                .toList();
    }

    private LabDrone drone(VehicleSpec kit) {
        return lab.ready(lab.add(kit));
    }

    private CommandView begin(LabDrone drone, List<MissionItemRequest.Waypoint> items) {
        return ann.give(drone, CommandRequests.uploadMission(List.copyOf(items)));
    }

    /** What the vehicle itself has last in its mission, whatever stands before. */
    private static List<Place> held(LabDrone drone, int count) {
        List<Place> all = drone.vehicle().autopilot().plan().items().stream()
                .map(item -> new Place(item.x(), item.y(), Math.round(item.z())))
                .toList();
        return all.subList(Math.max(0, all.size() - count), all.size());
    }

    private static void assertHolds(LabDrone drone, List<MissionItemRequest.Waypoint> items) {
        assertThat(held(drone, items.size()))
                .isEqualTo(items.stream().map(Place::of).toList());
    }

    private int done(CommandView given) {
        CommandView now = ann.now(given);
        CommandView.ProgressView progress = now.progress();
        return now.outcome() != null ? ENDED : progress == null ? -1 : progress.done();
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aLinkThatBreaksAtAnyItemOnlyDelaysTheUpload(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        for (int done : new int[] {0, 3, 7, 11}) {
            List<MissionItemRequest.Waypoint> items = waypoints(12, 100 * done);
            drone.wire().is(LabVehicleLink.Quality.late(50));
            CommandView upload = begin(drone, items);
            lab.until("it is that far", Duration.ofSeconds(20), () -> done(upload) >= done);
            drone.wire().cut();
            lab.until("the cut is felt", FELT, () -> drone.state().link().state() != LinkState.LIVE);
            drone.wire().mend();
            drone.wire().is(LabVehicleLink.Quality.GOOD);

            ann.succeeds(upload);
            assertHolds(drone, items);
        }
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void anItemThatTheVehicleSilentlyAlteredIsTold(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        drone.vehicle().alterations().alterItem(4);
        List<MissionItemRequest.Waypoint> items = waypoints(8, 0);

        CommandView.OutcomeView outcome =
                Objects.requireNonNull(ann.outcome(drone, CommandRequests.uploadMission(List.copyOf(items)))
                        .outcome());

        assertThat(outcome.result()).isEqualTo("failed");
        assertThat(outcome.reason()).contains("another mission than the one sent");
        assertThat(held(drone, items.size()))
                .isNotEqualTo(items.stream().map(Place::of).toList());
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aMissionGoesUpABadLink(VehicleSpec kit) {
        goesUpABadLink(kit, 6, Duration.ofMinutes(2));
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aLongMissionGoesUpABadLink(VehicleSpec kit) {
        goesUpABadLink(kit, 200, Duration.ofMinutes(30));
    }

    private void goesUpABadLink(VehicleSpec kit, int count, Duration longest) {
        LabDrone drone = drone(kit);
        List<MissionItemRequest.Waypoint> items = waypoints(count, 0);
        drone.wire().is(LabVehicleLink.Quality.BAD);
        drone.wire().doubles(0.02);

        CommandView upload = begin(drone, items);
        lab.untilSeen("it has ended", longest, () -> done(upload) == ENDED);

        ann.succeeds(upload);
        assertHolds(drone, items);
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void onlyWhatDiffersGoesUpWhereTheVehicleTakesParts(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        List<MissionItemRequest.Waypoint> items = new ArrayList<>(waypoints(30, 0));
        ann.succeeds(begin(drone, items));
        String firstHash = drone.state().mission().hash();
        assertThat(firstHash).isNotEmpty();
        MissionItemRequest.Waypoint old = items.get(7);
        items.set(7, waypoint(Objects.requireNonNull(old.latitude()), Objects.requireNonNull(old.longitude()), 44));
        LinkTap tap = drone.wire().tap();

        ann.succeeds(begin(drone, items));

        Set<Integer> asked = new TreeSet<>();
        tap.said(MissionRequest.ID, MissionRequest::decode).forEach(request -> asked.add(request.seq()));
        tap.said(MissionRequestInt.ID, MissionRequestInt::decode).forEach(request -> asked.add(request.seq()));
        // Home stands before the items of an ArduPilot mission, and the cloud puts a take-off in front.
        assertThat(asked)
                .isEqualTo(kit.isPx4() ? IntStream.range(0, 31).boxed().collect(Collectors.toSet()) : Set.of(9));
        assertHolds(drone, items);
        assertThat(drone.state().mission().hash()).isNotNull().isNotEqualTo(firstHash);
    }

    static Stream<Arguments> autopilotsAndLengths() {
        return VehicleSpec.autopilots().flatMap(kit -> Stream.of(Arguments.of(kit, 5), Arguments.of(kit, 80)));
    }

    @ParameterizedTest
    @MethodSource("autopilotsAndLengths")
    void aChangeBySomebodyElseIsNoticedAndTold(VehicleSpec kit, int count) {
        LabDrone drone = drone(kit);
        ann.succeeds(begin(drone, waypoints(count, 0)));
        assertThat(drone.state().mission().notice()).isNull();

        new DirectGroundStation(lab, drone).raiseItem(4, 7);

        String notice = lab.until(
                "the change is told",
                Duration.ofSeconds(120),
                () -> Optional.ofNullable(drone.state().mission().notice()));
        assertThat(notice).contains("differs");
        assertThat(drone.state().messages()).anyMatch(message -> message.text().contains("differs"));
    }

    private static FenceView.RallyView rallyOfEachReference() {
        return new FenceView.RallyView(
                List.of(
                        new FenceView.RallyPointView(47.395, 8.545, 25.0, "home"),
                        new FenceView.RallyPointView(47.396, 8.545, 430.0, "amsl"),
                        new FenceView.RallyPointView(47.397, 8.545, 60.0, "terrain")),
                List.of());
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void fenceAndRallyPointsGoRound(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        String id = drone.id().value();
        FenceService fences = lab.server().fences();
        DirectGroundStation station = new DirectGroundStation(lab, drone);
        FenceView.FencePointView corner = new FenceView.FencePointView(47.39, 8.54);
        FenceView.ReturnPointView backTo = new FenceView.ReturnPointView(47.401, 8.55, null, null);
        FenceView fence = new FenceView(
                List.of(
                        new FenceView.PolygonView(
                                true,
                                List.of(
                                        corner,
                                        new FenceView.FencePointView(47.41, 8.54),
                                        new FenceView.FencePointView(47.4, 8.56))),
                        new FenceView.CircleView(false, corner, 0.5)),
                backTo,
                List.of());
        FenceView.RallyView rally = rallyOfEachReference();
        assertThat(fences.fence(ann.principal(), id).zones()).isNull();

        ann.succeeds(fences.setFence(ann.caller(), id, fence));
        ann.succeeds(fences.setRallyPoints(ann.caller(), id, rally));

        assertThat(fences.fence(ann.principal(), id)).isEqualTo(fence);
        assertThat(fences.rallyPoints(ann.principal(), id)).isEqualTo(rally);
        assertThat(station.mission(1))
                .extracting(MissionItemInt::command)
                .containsExactly(5000, 5001, 5001, 5001, 5004);
        assertThat(station.mission(2)).extracting(MissionItemInt::command).containsOnly(5100);
        assertThat(station.mission(2)).extracting(MissionItemInt::frame).containsExactly(3, 0, 10);
        ann.succeeds(fences.clearFence(ann.caller(), id));
        ann.succeeds(fences.clearRallyPoints(ann.caller(), id));
        ann.succeeds(fences.readFence(ann.caller(), id));
        assertThat(fences.fence(ann.principal(), id).zones()).isEmpty();
        assertThat(station.mission(1)).isEmpty();
        assertThat(station.mission(2)).isEmpty();
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aBrokenFenceIsRefusedByNameAndLeavesTheOldOne(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        FenceView.FencePointView center = new FenceView.FencePointView(47.39, 8.54);
        FenceView fence = new FenceView(List.of(new FenceView.CircleView(false, center, 50.0)), null, null);
        FenceView broken = new FenceView(List.of(new FenceView.CircleView(true, null, null)), null, null);
        FenceService fences = lab.server().fences();
        ann.succeeds(fences.setFence(ann.caller(), drone.id().value(), fence));

        InvalidInput refused = catchThrowableOfType(
                InvalidInput.class,
                () -> fences.setFence(ann.caller(), drone.id().value(), broken));

        assertThat(refused.field()).isEqualTo("zones[0].center.latitude");
        assertThat(new DirectGroundStation(lab, drone).mission(1))
                .extracting(MissionItemInt::command)
                .containsExactly(5004);
    }
}
