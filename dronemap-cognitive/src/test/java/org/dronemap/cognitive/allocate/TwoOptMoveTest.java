package org.dronemap.cognitive.allocate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.junit.jupiter.api.Test;

/** Tours turned and exchanged at random stay tours, are what they say they are, and keep what they promise. */
class TwoOptMoveTest {
    private final RandomAllocationProblems instances = new RandomAllocationProblems(3);
    private final SplittableRandom random = new SplittableRandom(5);

    @Test
    void keepsToursWholeAndTellsWhatTheyAreWorth() {
        int changed = 0;
        for (int round = 0; round < 60; round++) {
            AllocationProblem instance = instances.any(30, 1 + round % 4);
            changed += walk(instance, 300);
        }
        assertThat(changed).isGreaterThan(1_000);
    }

    /** How many tries changed something. */
    private int walk(AllocationProblem instance, int tries) {
        LegCosts costs = new LegCosts(instance);
        TourLists tours = new TourLists(instance, costs);
        SearchCost worth = new SearchCost(tours, costs, instance.aim(), new OmissionPenalties(instance, costs));
        NeighbourLists near = new NeighbourLists(instance.legs(), tours.waypoints);
        new GreedyInsertion(tours, worth, costs, near, random).insertAll();
        tours.commit();
        worth.rescale();
        double current = worth.current();
        TwoOptMove reconnection = new TwoOptMove(tours, worth, costs, near, random);
        AllocationOracle judge = new AllocationOracle(instance);
        int changed = 0;
        for (int i = 0; i < tries; i++) {
            int[][] before = tours.orders();
            double now = reconnection.tryOne(current, current * 1.05);
            if (now == current) {
                assertThat(tours.orders()).isDeepEqualTo(before);
                continue;
            }
            changed++;
            current = now;
            assertThat(now).isLessThan(current * 1.05);
            assertThat(judge.faults(tours.orders())).isEmpty();
            assertThat(visited(tours)).isEqualTo(visited(before));
            assertThat(tours.longest()).isCloseTo(judge.verdict(tours.orders()).longest(), within(1e-6));
        }
        return changed;
    }

    private static List<Integer> visited(TourLists tours) {
        return visited(tours.orders());
    }

    private static List<Integer> visited(int[][] orders) {
        List<Integer> all = new ArrayList<>();
        Arrays.stream(orders).flatMapToInt(Arrays::stream).sorted().forEach(all::add);
        return all;
    }

    @Test
    void comesNearTheBoundWithALongTour() {
        AllocationProblem instance =
                instances.plain(400, 1, AllocationObjective.minSum(AllocationObjective.Measure.METERS));
        double sum = new Allocator(instance)
                .search(1, SearchBudget.iterations(40_000), better -> {})
                .sum();

        assertThat(sum).isLessThan(1.06 * LowerBound.of(instance, 200));
    }
}
