package org.dronemap.cognitive.allocate;

import org.dronemap.cognitive.cost.Instance;

/**
 * The immutable context that all searches of one problem share: costs, penalties and neighbour lists. Never changes,
 * safe for several threads.
 */
record Ground(Instance instance, Costs costs, Stakes stakes, Neighbours near) {
    static Ground of(Instance instance) {
        Costs costs = new Costs(instance);
        return new Ground(
                instance,
                costs,
                new Stakes(instance, costs),
                new Neighbours(instance.legs(), instance.visits().size()));
    }

    /** Nobody flies yet. */
    Tours tours() {
        return new Tours(instance, costs);
    }

    Worth worth(Tours tours) {
        return new Worth(tours, costs, instance.aim(), stakes);
    }

    /** What a plan is compared by; less is better. */
    double worth(Allocation allocation) {
        Tours tours = tours();
        tours.set(allocation.orders());
        return worth(tours).exact();
    }
}
