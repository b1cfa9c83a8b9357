package org.dronemap.cognitive.allocate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.cognitive.cost.AllocationDrone;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.dronemap.cognitive.cost.AllocationWaypoint;
import org.junit.jupiter.api.Test;

/** What the search is compared with: plain, but true to what a plan must keep to. */
class BaselineTest {
    private static final List<Baseline> ALL =
            List.of(new GivenOrderBaseline(), new NearestNeighbourBaseline(), new MoveAndImproveBaseline());

    private final RandomAllocationProblems instances = new RandomAllocationProblems(7);

    /** Waypoints on a line; drones that start and end at the given places of it. */
    private static AllocationProblem line(double[] waypoints, double[] starts, AllocationObjective aim) {
        int places = waypoints.length + 2 * starts.length;
        double[] east = Arrays.copyOf(waypoints, places);
        for (int r = 0; r < starts.length; r++) {
            east[waypoints.length + 2 * r] = starts[r];
            east[waypoints.length + 2 * r + 1] = starts[r];
        }
        BitSet all = new BitSet();
        all.set(0, starts.length);
        AllocationWaypoint visit = new AllocationWaypoint(0, 0, 1, 0, Double.POSITIVE_INFINITY, all);
        return new AllocationProblem(
                new PlanarLegs(east, new double[places], new double[] {1}, 0),
                Collections.nCopies(waypoints.length, visit),
                Collections.nCopies(starts.length, new AllocationDrone(0, 0, Double.POSITIVE_INFINITY)),
                aim);
    }

    @Test
    void keepToWindowsBatteriesAndSkills() {
        int served = 0;
        for (int problem = 0; problem < 200; problem++) {
            AllocationProblem instance = instances.any(25, 1 + problem % 4);
            AllocationOracle judge = new AllocationOracle(instance);
            for (Baseline baseline : ALL) {
                Allocation found = baseline.allocate(instance);

                assertThat(judge.faults(found.orders()))
                        .as("problem %d, %s", problem, baseline)
                        .isEmpty();
                int visited = Arrays.stream(found.orders())
                        .mapToInt(order -> order.length)
                        .sum();
                assertThat(visited + found.unserved().length).isEqualTo(25);
                served += visited;
            }
        }
        assertThat(served).isGreaterThan(200 * 25);
    }

    @Test
    void visitEveryWaypointWhereNothingForbidsIt() {
        for (int problem = 0; problem < 20; problem++) {
            AllocationProblem instance =
                    instances.plain(40, 1 + problem % 5, problem % 2 == 0 ? AllocationObjective.minMax() : minSum());
            for (Baseline baseline : ALL) {
                Allocation found = baseline.allocate(instance);

                assertThat(found.unserved()).isEmpty();
                assertThat(Arrays.stream(found.orders())
                                .flatMapToInt(Arrays::stream)
                                .sorted())
                        .containsExactlyElementsOf(
                                IntStream.range(0, 40).boxed().toList());
            }
        }
    }

    private static AllocationObjective minSum() {
        return AllocationObjective.minSum(AllocationObjective.Measure.SECONDS);
    }

    @Test
    void theGivenOrderIsCutIntoEqualStretches() {
        Allocation found = new GivenOrderBaseline().allocate(instances.plain(10, 3, AllocationObjective.minMax()));

        assertThat(found.orders()).isDeepEqualTo(new int[][] {{0, 1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
    }

    @Test
    void theDroneWithTheShortestTourGoesOnToTheNearestWaypoint() {
        AllocationProblem instance =
                line(new double[] {9, -2, 1, -5}, new double[] {0, 0}, AllocationObjective.minMax());

        Allocation found = new NearestNeighbourBaseline().allocate(instance);

        // 2 is nearest for drone 0; drone 1, still at home, takes 1; drone 0 is at 1 with a tour of 2, and goes on to
        // 3.
        assertThat(found.orders()).isDeepEqualTo(new int[][] {{2, 3}, {1, 0}});
        assertThat(found.longestSeconds()).isEqualTo(22);
    }

    @Test
    void dronesThatClaimTheSameWaypointsSettleWhoFliesThem() {
        // Both claim the two at 1 and -1, nobody those at 2 and -2.
        AllocationProblem instance =
                line(new double[] {1, 2, -1, -2}, new double[] {0, 0}, AllocationObjective.minMax());

        Allocation found = new MoveAndImproveBaseline().allocate(instance);

        assertThat(found.orders()[0]).containsExactlyInAnyOrder(0, 1);
        assertThat(found.orders()[1]).containsExactlyInAnyOrder(2, 3);
        assertThat(found.longestSeconds()).isEqualTo(4);
    }

    @Test
    void aDroneSellsWhatAnotherVisitsMoreCheaply() {
        // Each claims three. Nobody disputes the one at 25, though the other drone is much nearer: only a sale moves
        // it.
        AllocationProblem instance = line(new double[] {1, 2, 25, 30, 31, 32}, new double[] {0, 31}, minSum());

        Allocation found = new MoveAndImproveBaseline().allocate(instance);

        assertThat(found.orders()[0]).containsExactlyInAnyOrder(0, 1);
        assertThat(found.sum()).isEqualTo(18);
    }

    @Test
    void theMarketIsBetterThanTheNearestNeighbourAndTheSearchBetterThanBoth() {
        List<Double> market = new ArrayList<>();
        for (int problem = 0; problem < 20; problem++) {
            AllocationProblem instance = instances.plain(60, 4, AllocationObjective.minMax());
            double neighbour = new NearestNeighbourBaseline().allocate(instance).longestSeconds();
            double traded = new MoveAndImproveBaseline().allocate(instance).longestSeconds();
            double searched = new Allocator(instance)
                    .search(1, SearchBudget.iterations(5_000), better -> {})
                    .longestSeconds();
            market.add(traded / neighbour);

            assertThat(searched).as("problem %d", problem).isLessThan(Math.min(neighbour, traded));
        }
        assertThat(market.stream().mapToDouble(Double::doubleValue).sum()).isLessThan(market.size());
    }

    @Test
    void noDroneStaysIdleWhereAllShallFly() {
        AllocationProblem instance = line(new double[] {1, 2, 3, 4}, new double[] {0, 50}, minSum().withEveryDrone());

        assertThat(List.of(new MoveAndImproveBaseline().allocate(instance).orders()))
                .allSatisfy(order -> assertThat(order).isNotEmpty());
    }
}
