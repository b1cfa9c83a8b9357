package org.dronemap.cognitive.replan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.List;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.allocate.Allocation;
import org.dronemap.cognitive.allocate.Allocator;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.junit.jupiter.api.Test;

/** Drones get back what they were flying where that costs next to nothing, and only there. */
class AssignmentRestorationTest {
    /** Three drones far apart; w0 to w2 lie round the first one, w3 beside the second, w4 beside the third and w5 behind it. */
    private static final PlanningProblem PROBLEM = PlanningProblem.of(
            List.of(
                    PlanningFixtures.waypoint(0, 500, 0),
                    PlanningFixtures.waypoint(1, 500, 500),
                    PlanningFixtures.waypoint(2, 0, 500),
                    PlanningFixtures.waypoint(3, 5_000, 300),
                    PlanningFixtures.waypoint(4, 10_000, 300),
                    PlanningFixtures.waypoint(5, 10_000, 600)),
            List.of(
                    PlanningFixtures.craft(0, 0, 0),
                    PlanningFixtures.craft(1, 5_000, 0),
                    PlanningFixtures.craft(2, 10_000, 0)));

    private static final int[][] LIVE = {{0, 1, 2}, {3}, {4}};

    private final Allocator allocator = new Allocator(CostModel.of(PROBLEM).instance());

    private Allocation flown(int[]... orders) {
        BitSet everybody = new BitSet();
        everybody.set(0, orders.length);
        return allocator.insert(orders, everybody);
    }

    private int[][] fewestChanged(Allocation kept, Allocation found, boolean timeIsUp) {
        AssignmentRestoration restoring = new AssignmentRestoration(allocator, LIVE, Allocation::sum, () -> timeIsUp);
        return restoring.fewestChanged(kept, found).orders();
    }

    @Test
    void aTourThatIsFlownTheOtherWayRoundForNothingIsGivenBack() {
        Allocation kept = flown(new int[] {0, 1, 2}, new int[] {3, 5}, new int[] {4});
        Allocation found = flown(new int[] {2, 1, 0}, new int[] {3}, new int[] {4, 5});

        assertThat(fewestChanged(kept, found, false)).isDeepEqualTo(new int[][] {{0, 1, 2}, {3}, {4, 5}});
    }

    @Test
    void thePlanAtHandStaysWhereItIsAsGood() {
        Allocation kept = flown(new int[] {0, 1, 2}, new int[] {3}, new int[] {4, 5});
        Allocation found = flown(new int[] {2, 1, 0}, new int[] {3}, new int[] {5, 4});

        assertThat(fewestChanged(kept, found, true)).isDeepEqualTo(new int[][] {{0, 1, 2}, {3}, {4, 5}});
    }

    @Test
    void whatIsClearlyBetterIsNotGivenUpForIt() {
        Allocation kept = flown(new int[] {0, 1, 2}, new int[] {3, 5}, new int[] {4});
        Allocation found = flown(new int[] {0, 1, 2}, new int[] {3}, new int[] {4, 5});

        assertThat(fewestChanged(kept, found, false)[2]).containsExactly(4, 5);
    }

    @Test
    void ordersThatLeaveAWaypointToNobodyAreNotGivenBackForAPlanThatServesIt() {
        Allocation kept = flown(new int[] {0, 1, 2}, new int[] {3}, new int[] {4});
        Allocation found = flown(new int[] {0, 1, 2}, new int[] {3}, new int[] {4, 5});
        assertThat(kept.unserved()).containsExactly(5);

        assertThat(fewestChanged(kept, found, false)).isDeepEqualTo(new int[][] {{0, 1, 2}, {3}, {4, 5}});
        assertThat(fewestChanged(kept, found, true)).isDeepEqualTo(new int[][] {{0, 1, 2}, {3}, {4, 5}});
    }

    @Test
    void nothingMoreIsTriedWhenTheTimeIsUp() {
        Allocation kept = flown(new int[] {0, 1, 2}, new int[] {3, 5}, new int[] {4});
        Allocation found = flown(new int[] {2, 1, 0}, new int[] {3}, new int[] {4, 5});

        assertThat(fewestChanged(kept, found, true)[0]).containsExactly(2, 1, 0);
    }
}
