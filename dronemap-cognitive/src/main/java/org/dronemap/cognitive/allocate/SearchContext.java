package org.dronemap.cognitive.allocate;

import org.dronemap.cognitive.cost.AllocationProblem;

/**
 * The immutable context that all searches of one problem share: costs, penalties and neighbour lists. Never changes,
 * safe for several threads.
 */
record SearchContext(AllocationProblem instance, LegCosts costs, OmissionPenalties stakes, NeighbourLists near) {
    static SearchContext of(AllocationProblem instance) {
        LegCosts costs = new LegCosts(instance);
        return new SearchContext(
                instance,
                costs,
                new OmissionPenalties(instance, costs),
                new NeighbourLists(instance.legs(), instance.visits().size()));
    }

    /** Nobody flies yet. */
    TourLists tours() {
        return new TourLists(instance, costs);
    }

    SearchCost worth(TourLists tours) {
        return new SearchCost(tours, costs, instance.aim(), stakes);
    }

    /** What a plan is compared by; less is better. */
    double worth(Allocation allocation) {
        TourLists tours = tours();
        tours.set(allocation.orders());
        return worth(tours).exact();
    }
}
