package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.CameraFeedback;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleTrack;
import org.dronemap.ws.lab.ZoneFixtures;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.plan.PlanTaskRequest;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.run.RunRequest;
import org.dronemap.ws.run.RunView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What people want of a mission run while it flies, and what truly comes of it. */
class RunRequestsTest {
    private static final double SPACING_METERS = 60;
    private static final double HEIGHT_METERS = 20;
    private static final double NEAR_METERS = 5;
    private static final double FAR_METERS = 15;
    private static final double HOVER_SECONDS = 8;
    private static final double FENCE_METERS = 12;
    private static final int SERVO = 9;
    private static final int PULSE_MICROS = 1_900;
    private static final double METERS_PER_DEGREE = 111_195;

    private final Laboratory lab = new Laboratory(1);
    private final List<LabDrone> drones = lab.copters(2);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private PlanRequest.WaypointRequest waypoint(double north, double east, boolean hovers) {
        LabDrone first = drones.get(0);
        return MissionRunFlight.waypoint(
                first.place(north, east),
                first.groundAmsl() + HEIGHT_METERS,
                hovers ? HOVER_SECONDS : null,
                hovers ? tasks() : null);
    }

    private List<PlanTaskRequest> tasks() {
        Geodetic home = drones.get(0).place(0, 0);
        double ground = drones.get(0).groundAmsl();
        return List.of(
                new PlanTaskRequest.LookAt(home.latitudeDegrees(), home.longitudeDegrees(), ground),
                new PlanTaskRequest.Servo(SERVO, PULSE_MICROS),
                new PlanTaskRequest.Photo(),
                new PlanTaskRequest.ReadSensors(4.0));
    }

    /** In two columns; at the first of each column they hover and do tasks, if anywhere. */
    private MissionRunFlight begun(int count, String mode, boolean hover) {
        List<PlanRequest.WaypointRequest> places = IntStream.range(0, count)
                .mapToObj(n -> waypoint((1 + n / 2) * SPACING_METERS, n % 2 * SPACING_METERS, hover && n < 2))
                .toList();
        MissionRunFlight run =
                MissionRunFlight.begins(lab, chief, drones, places, new MissionRunFlight.Manner(mode, "continue", 2.0));
        return run.awaitsAll("flying");
    }

    private static Map<String, RunView.WaypointView> byId(RunView run) {
        return run.waypoints().stream().collect(Collectors.toMap(RunView.WaypointView::id, Function.identity()));
    }

    private static double apart(RunView.WaypointView one, Geodetic place) {
        return Geodesy.distanceMeters(MissionRunFlight.place(one), place);
    }

    /** The places of the mission that it was brought last. */
    private static List<Geodetic> carried(LabDrone drone) {
        List<Geodetic> places = new ArrayList<>();
        drone.wire().traffic().down(0, MissionItemInt.ID).stream()
                .map(heard -> MissionItemInt.decode(heard.frame()))
                .forEach(item -> {
                    if (item.seq() == 0) {
                        places.clear();
                    }
                    if (item.x() != 0 && item.y() != 0) {
                        places.add(new Geodetic(item.x() / 1e7, item.y() / 1e7));
                    }
                });
        return places;
    }

    /** For how many seconds it stood there, at most at a stretch. */
    private static double hovered(LabDrone drone, RunView.WaypointView waypoint) {
        double longest = 0;
        double since = -1;
        for (VehicleTrack.Fix fix : drone.track().since(0)) {
            boolean there = fix.metersTo(MissionRunFlight.place(waypoint), waypoint.altitudeAmsl()) < 2;
            double now = fix.atNanos() / 1e9;
            since = !there ? -1 : since < 0 ? now : since;
            longest = there ? Math.max(longest, now - since) : longest;
        }
        return longest;
    }

    /** The numbers of those that were taken there, by any of them. */
    private List<Integer> photos(RunView.WaypointView near) {
        return drones.stream()
                .flatMap(drone -> drone.wire().traffic().up(0, CameraFeedback.ID).stream())
                .map(heard -> CameraFeedback.decode(heard.frame()))
                .filter(said -> Math.hypot(
                                apart(near, new Geodetic(said.lat() / 1e7, said.lng() / 1e7)),
                                near.altitudeAmsl() - said.altMsl())
                        < NEAR_METERS)
                .map(CameraFeedback::imgIdx)
                .toList();
    }

    @Test
    void aMovedWaypointIsVisitedWhereItIsNowACancelledOneInNoMissionAndTasksAreDone() {
        drones.forEach(drone -> drone.vehicle().autopilot().payload().measure("Temp", 21.5f));
        MissionRunFlight run = begun(10, "automatic", true);
        List<String> first = run.next(drones.get(0));
        List<String> second = run.next(drones.get(1));
        RunView.WaypointView moved = run.waypoint(first.get(first.size() - 1));
        RunView.WaypointView cancelled = run.waypoint(second.get(second.size() - 1));
        double north = moved.latitude() + 45 / METERS_PER_DEGREE;
        lab.server()
                .runs()
                .move(
                        chief.principal(),
                        run.id(),
                        moved.id(),
                        new RunRequest.MoveRequest(north, moved.longitude(), null, null));
        lab.server().runs().cancel(chief.principal(), run.id(), cancelled.id());

        RunView over = run.end();

        assertThat(byId(over).get(cancelled.id()).state()).isEqualTo("cancelled");
        assertThat(byId(over).get(moved.id()).latitude()).isBetween(north - 1e-6, north + 1e-6);
        for (LabDrone drone : drones) {
            assertThat(carried(drone))
                    .isNotEmpty()
                    .allSatisfy(place -> assertThat(apart(cancelled, place)).isGreaterThan(FAR_METERS));
        }
        Set<String> changed = Set.of(moved.id(), cancelled.id());
        assertThat(over.waypoints())
                .filteredOn(one -> !one.id().equals(cancelled.id()))
                .allSatisfy(one -> {
                    assertThat(one.state()).isEqualTo("visited");
                    assertThat(run.missed(one)).isLessThan(NEAR_METERS);
                });
        assertThat(over.waypoints().subList(0, 2))
                .filteredOn(one -> !changed.contains(one.id()))
                .isNotEmpty()
                .allSatisfy(one -> requireTasksDone(run, one));
        assertThat(run.told("waypointMoved")).isNotEmpty();
        assertThat(run.told("waypointCancelled")).isNotEmpty();
        assertThat(run.decidesTheSameAgain()).isTrue();
    }

    private void requireTasksDone(MissionRunFlight run, RunView.WaypointView one) {
        String visitor = one.visits().get(0).drone();
        assertThat(hovered(run.drone(visitor), one)).isGreaterThanOrEqualTo(HOVER_SECONDS - 1);
        assertThat(one.tasks()).extracting(RunView.TaskView::result).containsOnly("done");
        assertThat(photos(one)).isEqualTo(List.of(one.tasks().get(2).photo()));
        assertThat(run.drone(visitor).vehicle().autopilot().payload().words())
                .contains("servo " + SERVO + ": " + PULSE_MICROS);
        assertThat(one.tasks().get(1).words()).contains("Output " + SERVO + " is at " + PULSE_MICROS);
        assertThat(one.tasks().get(3).words()).contains("Temp 21.5");
        assertThat(one.tasks().get(0).drone()).isEqualTo(visitor);
    }

    @Test
    void aChangedPlanWaitsForAnAnswerWherePeopleWantToBeAsked() {
        MissionRunFlight run = begun(8, "askFirst", false);
        LabDrone leaves = drones.get(0);
        LabDrone stays = drones.get(1);
        String heading = run.next(leaves).get(0);
        lab.server().runs().giveUp(chief.principal(), run.id(), leaves.id().value());
        RunView.ProposalView asked = lab.untilSeen(
                "it asks",
                Duration.ofSeconds(60),
                () -> Optional.ofNullable(run.view().proposal()));
        assertThat(asked.moved())
                .isNotEmpty()
                .extracting(RunView.MovedView::to)
                .containsOnly(stays.id().value());
        assertThat(asked.before().unserved()).isPositive();
        assertThat(asked.after().unserved()).isZero();
        // What it was flying to it may have come to before it turned.
        Set<String> orphans =
                asked.moved().stream().map(RunView.MovedView::waypoint).collect(Collectors.toSet());
        orphans.remove(heading);
        assertThat(run.next(stays)).doesNotContainAnyElementsOf(orphans);
        assertThat(refusal(() -> answer(run, asked.number() + 7))).isEqualTo(RejectionKind.CONFLICT);

        answer(run, asked.number());
        RunView over = run.end();

        assertThat(orphans)
                .isNotEmpty()
                .allSatisfy(
                        one -> assertThat(byId(over).get(one).visits().get(0).drone())
                                .isEqualTo(stays.id().value()));
        assertThat(over.waypoints())
                .allSatisfy(one -> assertThat(run.missed(one)).isLessThan(NEAR_METERS));
        assertThat(over.counts().visited()).isEqualTo(8);
        assertThat(run.told("answered")).isNotEmpty();
    }

    private void answer(MissionRunFlight run, int number) {
        lab.server()
                .runs()
                .answer(chief.principal(), run.id(), Integer.toString(number), new RunRequest.AnswerRequest(true));
    }

    private static RejectionKind refusal(Runnable what) {
        try {
            what.run();
        } catch (Rejection refused) {
            return refused.kind();
        }
        throw new AssertionError("It was not refused");
    }

    @Test
    void aPausedRunStandsStillAndItsDronesFlyHomeInLayersOfTheirOwn() {
        MissionRunFlight run = begun(2, "automatic", false);
        lab.server().runs().pause(chief.principal(), run.id());
        assertThat(refusal(() -> lab.server().runs().pause(chief.principal(), run.id())))
                .isEqualTo(RejectionKind.CONFLICT);
        lab.untilSeen("all hold", Duration.ofSeconds(30), () -> run.allAre("holding"));
        lab.until(
                "they stand",
                Duration.ofSeconds(10),
                () -> drones.stream().allMatch(drone -> drone.craft().body().groundSpeed() < 0.05));
        long since = lab.time().nanos();
        long visited = run.view().counts().visited();
        lab.goOn(Duration.ofSeconds(20));
        assertThat(drones)
                .allSatisfy(drone -> assertThat(drone.track().strayed(since)).isLessThan(0.5));
        assertThat(run.view().state()).isEqualTo("paused");
        assertThat(run.view().counts().visited()).isEqualTo(visited);

        lab.server().runs().goOn(chief.principal(), run.id());
        RunView over = run.end();

        assertThat(over.counts().visited()).isEqualTo(2);
        assertThat(run.told("paused")).isNotEmpty();
        assertThat(run.told("wentOn")).isNotEmpty();
        List<List<Double>> heights =
                drones.stream().map(RunRequestsTest::returnHeights).toList();
        // Before it is told its layer, it may have been told a height of its own as any that is armed from here.
        List<Double> layers = heights.stream()
                .map(one -> one.stream().mapToDouble(Double::doubleValue).max().orElseThrow())
                .sorted()
                .toList();
        assertThat(layers.get(0)).isGreaterThan(HEIGHT_METERS);
        assertThat(layers.get(1) - layers.get(0)).isGreaterThanOrEqualTo(5);
        assertThat(heights)
                .allSatisfy(one -> assertThat(one.get(one.size() - 1)).isIn(15.0, 30.0));
        lab.until(
                "all is as their owner had it",
                Duration.ofSeconds(90),
                () -> drones.stream()
                        .map(RunRequestsTest::returnHeights)
                        .allMatch(one -> one.get(one.size() - 1) == 15));
    }

    /** In metres, what that vehicle was told in turn. */
    private static List<Double> returnHeights(LabDrone drone) {
        return drone.wire().traffic().down(0, ParamSet.ID).stream()
                .map(heard -> ParamSet.decode(heard.frame()))
                .filter(said -> said.paramId().equals("RTL_ALT"))
                .map(said -> said.paramValue() / 100.0)
                .toList();
    }

    @Test
    void aNewZoneAJoiningDroneAndAWaypointOutOfReach() {
        LabDrone joining = lab.copter();
        // So many that the one that joins keeps some, whatever a better plan gives to others.
        MissionRunFlight run = begun(16, "automatic", false);
        run.joins(joining);
        lab.untilSeen(
                "it has its share",
                Duration.ofSeconds(30),
                () -> !run.next(joining).isEmpty());
        List<RunView.WaypointView> with = lab.server()
                .runs()
                .add(chief.principal(), run.id(), new RunRequest.WaypointsRequest(List.of(waypoint(30_000, 0, false))))
                .waypoints();
        String far = with.get(with.size() - 1).id();
        List<LabDrone> everybody =
                Stream.concat(drones.stream(), Stream.of(joining)).toList();
        RunView.WaypointView fenced = remotest(run, everybody);
        long begin = lab.time().nanos();
        lab.server()
                .zones()
                .add(
                        chief.principal(),
                        ZoneFixtures.circle("Crane", MissionRunFlight.place(fenced), FENCE_METERS, null, null));

        Map<String, String> leftOut = Map.of(far, "Out of range", fenced.id(), "Crane");
        lab.untilSeen(
                "reasons are told while it flies",
                Duration.ofSeconds(30),
                () -> leftOut.entrySet().stream()
                        .allMatch(one -> Objects.requireNonNullElse(
                                        run.waypoint(one.getKey()).why(), "")
                                .contains(one.getValue())));
        assertThat(run.view().state()).isEqualTo("running");
        RunView over = run.end();

        requireAllButThoseVisited(run, over, leftOut, joining);
        assertThat(everybody)
                .allSatisfy(drone -> assertThat(drone.track().nearestOverGround(MissionRunFlight.place(fenced), begin))
                        .isGreaterThan(FENCE_METERS));
    }

    private static void requireAllButThoseVisited(
            MissionRunFlight run, RunView over, Map<String, String> leftOut, LabDrone joining) {
        leftOut.forEach((one, why) -> {
            assertThat(byId(over).get(one).state()).isEqualTo("unserved");
            assertThat(byId(over).get(one).why()).contains(why);
        });
        List<RunView.WaypointView> served = over.waypoints().stream()
                .filter(one -> !leftOut.containsKey(one.id()))
                .toList();
        assertThat(served).hasSize(15).allSatisfy(one -> {
            assertThat(one.state()).isEqualTo("visited");
            assertThat(run.missed(one)).isLessThan(NEAR_METERS);
        });
        assertThat(new HashSet<>(
                        served.stream().map(one -> one.visits().get(0).drone()).toList()))
                .contains(joining.id().value());
    }

    /** The waypoint ahead from which all are farthest: a barrier round it surprises nobody in it. */
    private RunView.WaypointView remotest(MissionRunFlight run, List<LabDrone> everybody) {
        return everybody.stream()
                .flatMap(drone -> run.next(drone).stream())
                .map(run::waypoint)
                .max(Comparator.comparingDouble(one -> everybody.stream()
                        .mapToDouble(drone -> drone.distanceTo(MissionRunFlight.place(one)))
                        .min()
                        .orElseThrow()))
                .orElseThrow();
    }
}
