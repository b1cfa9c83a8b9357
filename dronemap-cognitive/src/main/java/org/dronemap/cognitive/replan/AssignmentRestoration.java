package org.dronemap.cognitive.replan;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.BooleanSupplier;
import java.util.function.ToDoubleFunction;
import org.dronemap.cognitive.allocate.Allocation;
import org.dronemap.cognitive.allocate.Allocator;

/**
 * In a re-planning, gives drones back the waypoints that they fly now where that costs next to nothing. Never changes.
 */
final class AssignmentRestoration {
    /** Which share of the cost a plan may lose for that. */
    private static final double WORTH_LOSING = 0.003;

    private final Allocator allocator;
    private final int[][] live;
    private final ToDoubleFunction<Allocation> cost;
    private final BooleanSupplier isOver;

    AssignmentRestoration(
            Allocator allocator, int[][] live, ToDoubleFunction<Allocation> cost, BooleanSupplier isOver) {
        this.allocator = allocator;
        this.live = live;
        this.cost = cost;
        this.isOver = isOver;
    }

    /** Of two plans, and of those between the better one and the live orders, the one that few drones change for. */
    Allocation fewestChanged(Allocation kept, Allocation found) {
        double most = cost.applyAsDouble(found) * (1 + WORTH_LOSING);
        int unserved = found.unserved().length;
        Allocation best = restored(found, most, unserved);
        boolean fewer = changed(kept).cardinality() <= changed(best).cardinality();
        return fewer && isGoodEnough(kept, most, unserved) ? kept : best;
    }

    private boolean isGoodEnough(Allocation allocation, double most, int unserved) {
        return allocation.unserved().length <= unserved && cost.applyAsDouble(allocation) <= most;
    }

    private Allocation restored(Allocation found, double most, int unserved) {
        Allocation best = found;
        BitSet changed = changed(best);
        for (int r = changed.nextSetBit(0); r >= 0 && !isOver.getAsBoolean(); r = changed.nextSetBit(r + 1)) {
            Allocation candidate = restore(best, r, changed);
            if (isGoodEnough(candidate, most, unserved)) {
                best = candidate;
                changed = changed(best);
            }
        }
        return best;
    }

    /** One drone gets back what it had; what it had got goes to others that change anyway. */
    private Allocation restore(Allocation allocation, int r, BitSet changed) {
        BitSet back = new BitSet();
        Arrays.stream(live[r]).forEach(back::set);
        int[][] orders = allocation.orders();
        for (int other = 0; other < orders.length; other++) {
            orders[other] = Arrays.stream(orders[other])
                    .filter(waypoint -> !back.get(waypoint))
                    .toArray();
        }
        orders[r] = live[r];
        BitSet closed = new BitSet();
        closed.set(0, live.length);
        closed.andNot(changed);
        closed.set(r);
        return allocator.insert(orders, closed);
    }

    private BitSet changed(Allocation allocation) {
        int[][] orders = allocation.orders();
        BitSet changed = new BitSet();
        for (int r = 0; r < orders.length; r++) {
            if (!Arrays.equals(orders[r], live[r])) {
                changed.set(r);
            }
        }
        return changed;
    }
}
