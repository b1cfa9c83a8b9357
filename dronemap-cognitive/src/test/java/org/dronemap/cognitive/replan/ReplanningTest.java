package org.dronemap.cognitive.replan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronemap.cognitive.Scenes;
import org.dronemap.cognitive.allocate.Budget;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.engine.Engine;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Stop;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.Problem;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Supply;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.cognitive.problem.Window;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** A plan that is being flown changes as little as need be, and loses no waypoint on the way. */
class ReplanningTest {
    private static final Budget SHORT = Budget.iterations(3_000);

    private static DroneId drone(int number) {
        return new DroneId("d" + number);
    }

    private static List<String> ids(int... waypoints) {
        return Arrays.stream(waypoints).mapToObj(i -> "w" + i).toList();
    }

    private static List<String> order(Plan plan, DroneId drone) {
        return plan.tours().stream()
                .filter(tour -> tour.drone().equals(drone))
                .flatMap(tour -> tour.stops().stream())
                .map(Stop::waypoint)
                .toList();
    }

    private static Craft inFlight(Craft craft, double east, double north) {
        return craft.with(Start.inFlight(Scenes.place(east, north, 450)));
    }

    @Test
    void keepsLiveOrdersAndPutsOrphansAmongThemAtOnce() {
        for (int seed = 1; seed <= 20; seed++) {
            Loss loss = Loss.of(seed, 40, 4);
            Replanned replanned = Engine.replanning(loss.situation()).atOnce();

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
        Loss loss = Loss.of(5, 40, 4);
        List<String> orphans = order(loss.plan(), drone(0));
        Replanned replanned = Engine.replanning(loss.situation()).atOnce();

        assertThat(replanned.changes().moved())
                .extracting(Moved::waypoint)
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
            Replanning replanning = Engine.replanning(Loss.of(seed, 40, 4).situation());
            Replanned first = replanning.atOnce();
            Replanned improved = replanning.improve(seed, SHORT);

            assertThat(improved.faults()).as("seed %d", seed).isEmpty();
            assertThat(improved.after().cost())
                    .isLessThanOrEqualTo(first.after().cost() * 1.0031);
            better += improved.after().cost() < 0.99 * first.after().cost() ? 1 : 0;
        }
        assertThat(better).isGreaterThan(5);
    }

    @Test
    void saysTheSameForTheSameSeedAndNumberOfIterations() {
        Situation situation = Loss.of(3, 40, 4).situation();

        assertThat(Engine.replanning(situation).improve(9, SHORT))
                .isEqualTo(Engine.replanning(situation).improve(9, SHORT));
    }

    @Test
    void changesOnlyTheDroneBesideWhichAWaypointComesUp() {
        List<Waypoint> waypoints = new ArrayList<>();
        List<Craft> crafts = new ArrayList<>();
        List<LiveOrder> live = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            int corner = i;
            crafts.add(Scenes.craft(i, 3_000 * (i % 3), 3_000 * Math.floorDiv(i, 3)));
            for (int j = 0; j < 5; j++) {
                waypoints.add(Scenes.waypoint(
                        5 * i + j, 3_000 * (i % 3) + 200 * j, 3_000 * Math.floorDiv(i, 3) + 300 + 50 * (j % 2)));
            }
            live.add(LiveOrder.of(
                    drone(i),
                    Stream.of(0, 1, 2, 3, 4).map(j -> "w" + (5 * corner + j)).toList()));
        }
        waypoints.add(Scenes.waypoint(30, 450, 360));

        Replanned replanned = Engine.replanning(new Situation(Problem.of(waypoints, crafts), live))
                .improve(1, Budget.iterations(20_000));

        assertThat(replanned.changes().drones()).containsExactly(drone(0));
        assertThat(replanned.changes().moved()).containsExactly(new Moved("w30", null, drone(0)));
    }

    @Test
    void changesNothingWhereNothingHasToChange() {
        Loss loss = Loss.of(2, 60, 4);
        Plan good = Engine.plan(loss.problem(), 1, Budget.iterations(60_000), progress -> {})
                .plan();
        Replanned replanned = Engine.replanning(new Situation(loss.problem(), Loss.live(good)))
                .improve(7, Budget.iterations(500));

        assertThat(replanned.changes().drones()).isEmpty();
        assertThat(replanned.changes().moved()).isEmpty();
        assertThat(replanned.before()).isEqualTo(replanned.after());
    }

    @Test
    void leavesWithADroneWhatItIsFlyingTo() {
        List<Waypoint> waypoints =
                Scenes.waypoints(new double[] {0, 900}, new double[] {0, 100}, new double[] {2_000, 100});
        Craft here = inFlight(Scenes.craft(0, 0, 0), 0, 0);
        Craft there = inFlight(Scenes.craft(1, 2_000, 0), 2_000, 0);
        Problem problem = Problem.of(waypoints, List.of(here, there));
        List<LiveOrder> firm = List.of(new LiveOrder(drone(0), ids(2), ids()), new LiveOrder(drone(1), ids(0), ids(1)));
        List<LiveOrder> free = List.of(LiveOrder.of(drone(0), ids(2)), LiveOrder.of(drone(1), ids(0, 1)));

        Replanned bound = Engine.replanning(new Situation(problem, firm)).improve(1, SHORT);
        assertThat(bound.faults()).isEmpty();
        assertThat(order(bound.plan(), drone(0)).get(0)).isEqualTo("w2");
        assertThat(order(bound.plan(), drone(1)).get(0)).isEqualTo("w0");

        Replanned loose = Engine.replanning(new Situation(problem, free)).improve(1, SHORT);
        assertThat(order(loose.plan(), drone(1))).containsExactly("w2");
        assertThat(loose.after().cost()).isLessThan(bound.after().cost());
    }

    @Test
    void letsGoOfWhatADroneCannotReachAnyMore() {
        List<Waypoint> waypoints = Scenes.waypoints(new double[] {0, 500}, new double[] {0, 4_000});
        Craft tired = inFlight(Scenes.craft(0, 0, 0), 0, 100).with(Supply.ofWattHours(8, 0));
        Craft fresh = Scenes.craft(1, 200, 0);
        Situation situation = new Situation(
                Problem.of(waypoints, List.of(tired, fresh)), List.of(new LiveOrder(drone(0), ids(1), ids(0))));

        Replanned replanned = Engine.replanning(situation).atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(order(replanned.plan(), drone(0))).containsExactly("w0");
        assertThat(order(replanned.plan(), drone(1))).containsExactly("w1");
        assertThat(replanned.changes().moved()).containsExactly(new Moved("w1", drone(0), drone(1)));
    }

    @Test
    void givesUpTheLeastImportantWhereABatteryDoesNotReach() {
        List<Waypoint> waypoints = List.of(
                new Waypoint("far", Scenes.place(0, 3_000, 450), Task.FLY_THROUGH, 5, Window.ALWAYS),
                new Waypoint("aside", Scenes.place(3_000, 0, 450), Task.FLY_THROUGH, 1, Window.ALWAYS));
        Craft only = inFlight(Scenes.craft(0, 0, 0), 0, 0).with(Supply.ofWattHours(35, 0));
        Situation situation = new Situation(
                Problem.of(waypoints, List.of(only)), List.of(LiveOrder.of(drone(0), List.of("aside", "far"))));

        Replanned replanned = Engine.replanning(situation).atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(order(replanned.plan(), drone(0))).containsExactly("far");
        assertThat(replanned.changes().moved()).containsExactly(new Moved("aside", drone(0), null));
        assertThat(replanned.plan().unserved())
                .singleElement()
                .satisfies(one -> assertThat(one.why()).isNotBlank());
    }

    @Test
    void leadsRoundANewFence() {
        List<Waypoint> waypoints = Scenes.waypoints(new double[] {0, 1_000}, new double[] {300, 1_200});
        Barrier fence = new Barrier(
                "the new fence", new FenceZone.Circle(false, Scenes.point(0, 500), 200), AltitudeBand.ALL, Set.of());
        Problem problem = Problem.of(waypoints, List.of(inFlight(Scenes.craft(0, 0, 0), 0, 100)))
                .withBarriers(List.of(fence));

        Replanned replanned = Engine.replanning(
                        new Situation(problem, List.of(new LiveOrder(drone(0), ids(0), ids(1)))))
                .atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(order(replanned.plan(), drone(0))).containsExactly("w0", "w1");
        assertThat(replanned.plan().tours().get(0).way(0).via()).isNotEmpty();
    }

    @Test
    void keepsDronesApartOnTheirWayToTheNewPlan() {
        List<Waypoint> waypoints = Scenes.waypoints(new double[] {400, 0}, new double[] {-400, 0});
        Craft one = inFlight(Scenes.craft(0, -400, 5), -380, 5);
        Craft other = inFlight(Scenes.craft(1, 400, -5), 380, -5);
        Situation situation = new Situation(
                Problem.of(waypoints, List.of(one, other)),
                List.of(new LiveOrder(drone(0), ids(0), ids()), new LiveOrder(drone(1), ids(1), ids())));

        assertThat(Engine.replanning(situation).atOnce().faults()).isEmpty();
    }

    /** The waypoint w2 lies beside what the first drone flies, and is nobody's. */
    private static Situation besideTheFirst(boolean firstIsBusy, Craft second) {
        List<Waypoint> waypoints =
                Scenes.waypoints(new double[] {0, 400}, new double[] {300, 400}, new double[] {10, 300});
        return new Situation(
                Problem.of(waypoints, List.of(Scenes.craft(0, 0, 0), second)),
                List.of(
                        new LiveOrder(drone(0), ids(), ids(0), firstIsBusy),
                        new LiveOrder(drone(1), ids(), ids(1), false)));
    }

    @Test
    void givesWhatHasToGoOutAtOnceToThoseThatCanBeToldOfIt() {
        Craft second = Scenes.craft(1, 300, 0);

        Replanned free = Engine.replanning(besideTheFirst(false, second)).atOnce();
        Replanned busy = Engine.replanning(besideTheFirst(true, second)).atOnce();

        assertThat(order(free.plan(), drone(0))).containsExactly("w2", "w0");
        assertThat(order(busy.plan(), drone(0))).containsExactly("w0");
        assertThat(order(busy.plan(), drone(1))).contains("w2");
    }

    @Test
    void givesItToABusyDroneRatherThanToNobody() {
        Craft tired = Scenes.craft(1, 300, 0).with(new Supply(1, 0));

        Replanned replanned = Engine.replanning(besideTheFirst(true, tired)).atOnce();

        assertThat(order(replanned.plan(), drone(0))).contains("w2");
    }

    @Test
    void servesAWaypointThatMovedAndForgetsOneThatWasCancelled() {
        List<Waypoint> waypoints = List.of(Scenes.waypoint(0, 0, 800), Scenes.waypoint(2, 500, 500));
        Situation situation = new Situation(
                Problem.of(waypoints, List.of(Scenes.craft(0, 0, 0))), List.of(LiveOrder.of(drone(0), ids(0, 1, 2))));

        Replanned replanned = Engine.replanning(situation).atOnce();

        assertThat(order(replanned.plan(), drone(0))).containsExactly("w0", "w2");
        assertThat(replanned.changes().drones()).isEmpty();
    }

    @Test
    void worksTowardsTheLeastSumAsWellAndKeepsEveryDroneBusy() {
        Loss loss = Loss.of(4, 40, 4);
        Problem problem = loss.situation().problem().with(new Objective(0, Objective.Measure.JOULES, 1, true));
        Replanning replanning =
                Engine.replanning(new Situation(problem, loss.situation().live()));

        Replanned improved = replanning.improve(1, SHORT);

        assertThat(improved.faults()).isEmpty();
        double joules =
                improved.plan().tours().stream().mapToDouble(Tour::usedJoules).sum();
        assertThat(improved.after().sum()).isBetween(0.95 * joules, 1.05 * joules);
        assertThat(improved.after().cost())
                .isLessThanOrEqualTo(replanning.atOnce().after().cost() * 1.0031);
    }

    @Test
    void countsAWaypointToComeAsAVisitOfItsDrone() {
        List<Waypoint> waypoints = Scenes.waypoints(new double[] {0, 500}, new double[] {0, 600});
        Problem problem = Problem.of(
                        waypoints, List.of(inFlight(Scenes.craft(0, 0, 0), 0, 0), Scenes.craft(1, 3_000, 0)))
                .with(new Objective(1, Objective.Measure.SECONDS, 0, true));
        Situation situation =
                new Situation(problem, List.of(new LiveOrder(drone(0), ids(0), ids()), LiveOrder.of(drone(1), ids(1))));

        Replanned replanned = Engine.replanning(situation).atOnce();

        assertThat(replanned.faults()).isEmpty();
        assertThat(replanned.changes().drones()).isEmpty();
    }

    @Test
    void neverLosesAWaypointWhateverHappens() {
        SplittableRandom random = new SplittableRandom(12);
        for (int round = 0; round < 60; round++) {
            Situation situation = anySituation(random);
            Replanning replanning = Engine.replanning(situation);
            for (Replanned replanned : List.of(replanning.atOnce(), replanning.improve(round, SHORT))) {
                List<String> told = new ArrayList<>();
                replanned.plan().tours().forEach(tour -> tour.stops().forEach(stop -> told.add(stop.waypoint())));
                replanned.plan().unserved().forEach(one -> told.add(one.waypoint()));

                assertThat(told)
                        .as("round %d", round)
                        .containsExactlyInAnyOrderElementsOf(situation.problem().waypoints().stream()
                                .map(Waypoint::id)
                                .toList());
                assertThat(replanned.faults())
                        .as("round %d", round)
                        .filteredOn(fault -> !fault.contains("m apart"))
                        .isEmpty();
                assertThat(replanned.after().unserved())
                        .isEqualTo(replanned.plan().unserved().size());
            }
        }
    }

    /** Drones in the air and on the ground, some with little left, windows, one drone gone, new and cancelled waypoints. */
    private static Situation anySituation(SplittableRandom random) {
        List<Waypoint> waypoints = new ArrayList<>();
        for (int i = 0; i < 25; i++) {
            double opens = random.nextInt(3) == 0 ? random.nextDouble(300) : 0;
            double closes = random.nextInt(3) == 0 ? opens + random.nextDouble(600) : Double.POSITIVE_INFINITY;
            waypoints.add(new Waypoint(
                    "w" + i,
                    Scenes.place(random.nextDouble(-1_500, 1_500), random.nextDouble(-1_500, 1_500), 450),
                    new Task(random.nextInt(5), Set.of()),
                    1 + random.nextInt(3),
                    new Window(opens, closes)));
        }
        List<Craft> crafts = new ArrayList<>();
        for (int r = 0; r < 4; r++) {
            Craft craft = Scenes.craft(r, 500 * r, 0);
            craft = random.nextBoolean() ? inFlight(craft, 500 * r, random.nextDouble(-800, 800)) : craft;
            crafts.add(random.nextInt(3) == 0 ? craft.with(Supply.ofWattHours(random.nextDouble(20, 60), 2)) : craft);
        }
        List<LiveOrder> live = new ArrayList<>();
        for (int r = 0; r < 5; r++) {
            live.add(new LiveOrder(drone(r), ids(6 * r), ids(6 * r + 1, 6 * r + 2, 6 * r + 3, 6 * r + 4)));
        }
        return new Situation(Problem.of(waypoints, crafts), live);
    }

    @Test
    void costsTheSameAsItsPlanTakes() {
        Situation situation = Loss.of(6, 40, 4).situation();
        Replanned replanned = Engine.replanning(situation).atOnce();
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
        assertThatThrownBy(() -> new Situation(
                        Problem.of(List.of(), Scenes.crafts(2)),
                        List.of(LiveOrder.of(drone(0), ids(1)), LiveOrder.of(drone(1), ids(1)))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("w1");
    }
}
