package org.dronemap.cognitive.allocate;

import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;

/** The best plan that several searches have found so far; tells a listener of each better one. Guarded by itself. */
final class Incumbent {
    private static final double ROUNDING = 1e-9;

    private final ToDoubleFunction<Allocation> worths;
    private final Consumer<Allocation> improved;
    private double worth = Double.POSITIVE_INFINITY;
    private @Nullable Allocation plan;

    Incumbent(ToDoubleFunction<Allocation> worths, Consumer<Allocation> improved) {
        this.worths = worths;
        this.improved = improved;
    }

    synchronized void offer(Allocation found) {
        double its = worths.applyAsDouble(found);
        if (plan == null || its < worth - ROUNDING * Math.abs(worth)) {
            worth = its;
            plan = found;
            improved.accept(found);
        }
    }

    /** The first of equals; none was offered: a fault of the caller. */
    synchronized Allocation plan() {
        if (plan == null) {
            throw new IllegalStateException("no search has found a plan");
        }
        return plan;
    }
}
