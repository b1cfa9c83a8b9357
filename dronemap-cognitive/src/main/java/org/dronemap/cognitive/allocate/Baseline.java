package org.dronemap.cognitive.allocate;

import org.dronemap.cognitive.cost.AllocationProblem;

/** A simple allocation method that benchmarks compare the search with. Safe for several threads. */
@FunctionalInterface
public interface Baseline {
    /** Tours that can be flown; waypoints that it finds no drone for are left out. */
    Allocation allocate(AllocationProblem instance);
}
