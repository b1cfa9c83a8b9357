package org.dronemap.cognitive.allocate;

import org.dronemap.cognitive.cost.AllocationProblem;

/** A plain way to plan, kept so that what the search gains can be measured. Safe for several threads. */
@FunctionalInterface
public interface Baseline {
    /** Tours that can be flown; waypoints that it finds no drone for are left out. */
    Allocation allocate(AllocationProblem instance);
}
