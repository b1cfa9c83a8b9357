package org.dronemap.cognitive.replan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** A plan that is being flown changes as little as need be, and loses no waypoint on the way. */
class ReplannerTest {
    static final SearchBudget SHORT = SearchBudget.iterations(3_000);

    static DroneId drone(int number) {
        return new DroneId("d" + number);
    }

    static List<String> ids(int... waypoints) {
        return Arrays.stream(waypoints).mapToObj(i -> "w" + i).toList();
    }

    private static List<String> order(Plan plan, DroneId drone) {
        return plan.tours().stream()
                .filter(tour -> tour.drone().equals(drone))
                .flatMap(tour -> tour.stops().stream())
                .map(TourStop::waypoint)
                .toList();
    }

    static Craft inFlight(Craft craft, double east, double north) {
        return craft.with(Start.inFlight(PlanningFixtures.place(east, north, 450)));
    }

    @Test
    void keepsLiveOrdersAndPutsOrphansAmongThemAtOnce() {
        for (int seed = 1; seed <= 20; seed++) {
            DroneLoss loss = DroneLoss.of(seed, 40, 4);
            ReplanResult replanned = FleetPlanner.replanning(loss.situation()).atOnce();

            assertThat(replanned.faults()).as("seed %d", seed).isEmpty();
            assertThat(replanned.plan().unserved()).isEmpty();
            for (Tour tour : loss.plan().tours()) {
                if (!tour.drone().equals(drone(0))) {
                    List<String> before = order(loss.plan(), tour.drone());
                    List<String> after = new ArrayList<>(order(replanned.plan(), tour.drone()));
                    after.retainAll(before);
                    assertThat(after).isEqualTo(before);
                }
            }
        }
    }

    @Test
    void tellsWhatMovedFromWhomToWhomAndWhatItCosts() {
        DroneLoss loss = DroneLoss.of(5, 40, 4);
        List<String> orphans = order(loss.plan(), drone(0));
        ReplanResult replanned = FleetPlanner.replanning(loss.situation()).atOnce();

        assertThat(replanned.changes().moved())
                .extracting(ReassignedWaypoint::waypoint)
                .containsExactlyInAnyOrderElementsOf(orphans);
        assertThat(replanned.changes().moved()).allSatisfy(moved -> {
            assertThat(moved.from()).isEqualTo(drone(0));
            assertThat(moved.to()).isIn(drone(1), drone(2), drone(3));
            assertThat(order(replanned.plan(), moved.to())).contains(moved.waypoint());
        });
        assertThat(replanned.before().unserved()).isEqualTo(orphans.size());
        assertThat(replanned.after().unserved()).isZero();
        assertThat(replanned.after().longestSeconds())
                .isGreaterThan(replanned.before().longestSeconds());
    }

    @Test
    void getsBetterWithinItsBudgetAndNeverWorse() {
        int better = 0;
        for (int seed = 1; seed <= 20; seed++) {
            Replanner replanning =
                    FleetPlanner.replanning(DroneLoss.of(seed, 40, 4).situation());
            ReplanResult first = replanning.atOnce();
            ReplanResult improved = replanning.improve(seed, SHORT);

            assertThat(improved.faults()).as("seed %d", seed).isEmpty();
            assertThat(improved.after().cost())
                    .isLessThanOrEqualTo(first.after().cost() * 1.0031);
            better += improved.after().cost() < 0.99 * first.after().cost() ? 1 : 0;
        }
        assertThat(better).isGreaterThan(5);
    }

    @Test
    void saysTheSameForTheSameSeedAndNumberOfIterations() {
        ReplanSituation situation = DroneLoss.of(3, 40, 4).situation();

        assertThat(FleetPlanner.replanning(situation).improve(9, SHORT))
                .isEqualTo(FleetPlanner.replanning(situation).improve(9, SHORT));
    }

    @Test
    void changesOnlyTheDroneBesideWhichAWaypointComesUp() {
        List<Waypoint> waypoints = new ArrayList<>();
        List<Craft> crafts = new ArrayList<>();
        List<LiveAssignment> live = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            int corner = i;
            crafts.add(PlanningFixtures.craft(i, 3_000 * (i % 3), 3_000 * Math.floorDiv(i, 3)));
            for (int j = 0; j < 5; j++) {
                waypoints.add(PlanningFixtures.waypoint(
                        5 * i + j, 3_000 * (i % 3) + 200 * j, 3_000 * Math.floorDiv(i, 3) + 300 + 50 * (j % 2)));
            }
            live.add(LiveAssignment.of(
                    drone(i),
                    Stream.of(0, 1, 2, 3, 4).map(j -> "w" + (5 * corner + j)).toList()));
        }
        waypoints.add(PlanningFixtures.waypoint(30, 450, 360));

        ReplanResult replanned = FleetPlanner.replanning(
                        new ReplanSituation(PlanningProblem.of(waypoints, crafts), live))
                .improve(1, SearchBudget.iterations(20_000));

        assertThat(replanned.changes().drones()).containsExactly(drone(0));
        assertThat(replanned.changes().moved()).containsExactly(new ReassignedWaypoint("w30", null, drone(0)));
    }

    @Test
    void changesNothingWhereNothingHasToChange() {
        DroneLoss loss = DroneLoss.of(2, 60, 4);
        Plan good = FleetPlanner.plan(loss.problem(), 1, SearchBudget.iterations(60_000), progress -> {})
                .plan();
        ReplanResult replanned = FleetPlanner.replanning(new ReplanSituation(loss.problem(), DroneLoss.live(good)))
                .improve(7, SearchBudget.iterations(500));

        assertThat(replanned.changes().drones()).isEmpty();
        assertThat(replanned.changes().moved()).isEmpty();
        assertThat(replanned.before()).isEqualTo(replanned.after());
    }

    @Test
    void leavesWithADroneWhatItIsFlyingTo() {
        List<Waypoint> waypoints =
                PlanningFixtures.waypoints(new double[] {0, 900}, new double[] {0, 100}, new double[] {2_000, 100});
        Craft here = inFlight(PlanningFixtures.craft(0, 0, 0), 0, 0);
        Craft there = inFlight(PlanningFixtures.craft(1, 2_000, 0), 2_000, 0);
        PlanningProblem problem = PlanningProblem.of(waypoints, List.of(here, there));
        List<LiveAssignment> firm =
                List.of(new LiveAssignment(drone(0), ids(2), ids()), new LiveAssignment(drone(1), ids(0), ids(1)));
        List<LiveAssignment> free =
                List.of(LiveAssignment.of(drone(0), ids(2)), LiveAssignment.of(drone(1), ids(0, 1)));

        ReplanResult bound =
                FleetPlanner.replanning(new ReplanSituation(problem, firm)).improve(1, SHORT);
        assertThat(bound.faults()).isEmpty();
        assertThat(order(bound.plan(), drone(0)).get(0)).isEqualTo("w2");
        assertThat(order(bound.plan(), drone(1)).get(0)).isEqualTo("w0");

        ReplanResult loose =
                FleetPlanner.replanning(new ReplanSituation(problem, free)).improve(1, SHORT);
        assertThat(order(loose.plan(), drone(1))).containsExactly("w2");
        assertThat(loose.after().cost()).isLessThan(bound.after().cost());
    }

    @Test
    void letsGoOfWhatADroneCannotReachAnyMore() {
        List<Waypoint> waypoints = PlanningFixtures.waypoints(new double[] {0, 500}, new double[] {0, 4_000});
        Craft tired = inFlight(PlanningFixtures.craft(0, 0, 0), 0, 100).with(EnergyBudget.ofWattHours(8, 0));
        Craft fresh = PlanningFixtures.craft(1, 200, 0);
        ReplanSituation situation = new ReplanSituation(
                PlanningProblem.of(waypoints, List.of(tired, fresh)),
                List.of(new LiveAssignment(drone(0), ids(1), ids(0))));

        ReplanResult replanned = FleetPlanner.replanning(situation).atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(order(replanned.plan(), drone(0))).containsExactly("w0");
        assertThat(order(replanned.plan(), drone(1))).containsExactly("w1");
        assertThat(replanned.changes().moved()).containsExactly(new ReassignedWaypoint("w1", drone(0), drone(1)));
    }

    @Test
    void givesUpTheLeastImportantWhereABatteryDoesNotReach() {
        List<Waypoint> waypoints = List.of(
                new Waypoint("far", PlanningFixtures.place(0, 3_000, 450), Task.FLY_THROUGH, 5, TimeWindow.ALWAYS),
                new Waypoint("aside", PlanningFixtures.place(3_000, 0, 450), Task.FLY_THROUGH, 1, TimeWindow.ALWAYS));
        Craft only = inFlight(PlanningFixtures.craft(0, 0, 0), 0, 0).with(EnergyBudget.ofWattHours(35, 0));
        ReplanSituation situation = new ReplanSituation(
                PlanningProblem.of(waypoints, List.of(only)),
                List.of(LiveAssignment.of(drone(0), List.of("aside", "far"))));

        ReplanResult replanned = FleetPlanner.replanning(situation).atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(order(replanned.plan(), drone(0))).containsExactly("far");
        assertThat(replanned.changes().moved()).containsExactly(new ReassignedWaypoint("aside", drone(0), null));
        assertThat(replanned.plan().unserved())
                .singleElement()
                .satisfies(one -> assertThat(one.why()).isNotBlank());
    }

    @Test
    void leadsRoundANewFence() {
        List<Waypoint> waypoints = PlanningFixtures.waypoints(new double[] {0, 1_000}, new double[] {300, 1_200});
        Barrier fence = new Barrier(
                "the new fence",
                new FenceArea.Circle(false, PlanningFixtures.point(0, 500), 200),
                AltitudeBand.ALL,
                Set.of());
        PlanningProblem problem = PlanningProblem.of(
                        waypoints, List.of(inFlight(PlanningFixtures.craft(0, 0, 0), 0, 100)))
                .withBarriers(List.of(fence));

        ReplanResult replanned = FleetPlanner.replanning(
                        new ReplanSituation(problem, List.of(new LiveAssignment(drone(0), ids(0), ids(1)))))
                .atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(order(replanned.plan(), drone(0))).containsExactly("w0", "w1");
        assertThat(replanned.plan().tours().get(0).way(0).via()).isNotEmpty();
    }

    @Test
    void keepsDronesApartOnTheirWayToTheNewPlan() {
        List<Waypoint> waypoints = PlanningFixtures.waypoints(new double[] {400, 0}, new double[] {-400, 0});
        Craft one = inFlight(PlanningFixtures.craft(0, -400, 5), -380, 5);
        Craft other = inFlight(PlanningFixtures.craft(1, 400, -5), 380, -5);
        ReplanSituation situation = new ReplanSituation(
                PlanningProblem.of(waypoints, List.of(one, other)),
                List.of(new LiveAssignment(drone(0), ids(0), ids()), new LiveAssignment(drone(1), ids(1), ids())));

        assertThat(FleetPlanner.replanning(situation).atOnce().faults()).isEmpty();
    }

    /** The waypoint w2 lies beside what the first drone flies, and is nobody's. */
    private static ReplanSituation besideTheFirst(boolean firstIsBusy, Craft second) {
        List<Waypoint> waypoints =
                PlanningFixtures.waypoints(new double[] {0, 400}, new double[] {300, 400}, new double[] {10, 300});
        return new ReplanSituation(
                PlanningProblem.of(waypoints, List.of(PlanningFixtures.craft(0, 0, 0), second)),
                List.of(
                        new LiveAssignment(drone(0), ids(), ids(0), firstIsBusy),
                        new LiveAssignment(drone(1), ids(), ids(1), false)));
    }

    @Test
    void givesWhatHasToGoOutAtOnceToThoseThatCanBeToldOfIt() {
        Craft second = PlanningFixtures.craft(1, 300, 0);

        ReplanResult free =
                FleetPlanner.replanning(besideTheFirst(false, second)).atOnce();
        ReplanResult busy =
                FleetPlanner.replanning(besideTheFirst(true, second)).atOnce();

        assertThat(order(free.plan(), drone(0))).containsExactly("w2", "w0");
        assertThat(order(busy.plan(), drone(0))).containsExactly("w0");
        assertThat(order(busy.plan(), drone(1))).contains("w2");
    }

    @Test
    void givesItToABusyDroneRatherThanToNobody() {
        Craft tired = PlanningFixtures.craft(1, 300, 0).with(new EnergyBudget(1, 0));

        ReplanResult replanned =
                FleetPlanner.replanning(besideTheFirst(true, tired)).atOnce();

        assertThat(order(replanned.plan(), drone(0))).contains("w2");
    }

    @Test
    void servesAWaypointThatMovedAndForgetsOneThatWasCancelled() {
        List<Waypoint> waypoints =
                List.of(PlanningFixtures.waypoint(0, 0, 800), PlanningFixtures.waypoint(2, 500, 500));
        ReplanSituation situation = new ReplanSituation(
                PlanningProblem.of(waypoints, List.of(PlanningFixtures.craft(0, 0, 0))),
                List.of(LiveAssignment.of(drone(0), ids(0, 1, 2))));

        ReplanResult replanned = FleetPlanner.replanning(situation).atOnce();

        assertThat(order(replanned.plan(), drone(0))).containsExactly("w0", "w2");
        assertThat(replanned.changes().drones()).isEmpty();
    }

    @Test
    void worksTowardsTheLeastSumAsWellAndKeepsEveryDroneBusy() {
        DroneLoss loss = DroneLoss.of(4, 40, 4);
        PlanningProblem problem = loss.situation().problem().with(new Objective(0, Objective.Measure.JOULES, 1, true));
        Replanner replanning = FleetPlanner.replanning(
                new ReplanSituation(problem, loss.situation().live()));

        ReplanResult improved = replanning.improve(1, SHORT);

        assertThat(improved.faults()).isEmpty();
        double joules =
                improved.plan().tours().stream().mapToDouble(Tour::usedJoules).sum();
        assertThat(improved.after().sum()).isBetween(0.95 * joules, 1.05 * joules);
        assertThat(improved.after().cost())
                .isLessThanOrEqualTo(replanning.atOnce().after().cost() * 1.0031);
    }

    @Test
    void countsAWaypointToComeAsAVisitOfItsDrone() {
        List<Waypoint> waypoints = PlanningFixtures.waypoints(new double[] {0, 500}, new double[] {0, 600});
        PlanningProblem problem = PlanningProblem.of(
                        waypoints,
                        List.of(inFlight(PlanningFixtures.craft(0, 0, 0), 0, 0), PlanningFixtures.craft(1, 3_000, 0)))
                .with(new Objective(1, Objective.Measure.SECONDS, 0, true));
        ReplanSituation situation = new ReplanSituation(
                problem, List.of(new LiveAssignment(drone(0), ids(0), ids()), LiveAssignment.of(drone(1), ids(1))));

        ReplanResult replanned = FleetPlanner.replanning(situation).atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(replanned.changes().drones()).isEmpty();
    }

    @Test
    void costsTheSameAsItsPlanTakes() {
        ReplanSituation situation = DroneLoss.of(6, 40, 4).situation();
        ReplanResult replanned = FleetPlanner.replanning(situation).atOnce();
        CostModel costs = CostModel.of(situation.problem());
        int[][] orders = situation.problem().crafts().stream()
                .map(craft -> order(replanned.plan(), craft.id()).stream()
                        .mapToInt(id -> Integer.parseInt(id.substring(1)))
                        .toArray())
                .toArray(int[][]::new);

        assertThat(costs.plan(orders).endsSeconds()).isCloseTo(replanned.after().longestSeconds(), offset(1e-6));
    }

    @Test
    void refusesAWaypointThatTwoDronesFlyTo() {
        assertThatThrownBy(() -> new ReplanSituation(
                        PlanningProblem.of(List.of(), PlanningFixtures.crafts(2)),
                        List.of(LiveAssignment.of(drone(0), ids(1)), LiveAssignment.of(drone(1), ids(1)))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("w1");
    }
}
