package org.dronemap.sim.autopilot;

import java.util.HashSet;
import java.util.Set;

/**
 * Injected faults of a simulated vehicle that silently stores parameters or mission items otherwise than sent. Owned by
 * its vehicle.
 */
public final class SimulatedStorageFaults {
    private final Set<String> parameters = new HashSet<>();
    private final Set<Integer> items = new HashSet<>();

    /** Every value written to that parameter is kept one too high. */
    public void alterParameter(String name) {
        parameters.add(name);
    }

    /** That item of every mission is kept five metres too high. */
    public void alterItem(int index) {
        items.add(index);
    }

    public void clear() {
        parameters.clear();
        items.clear();
    }

    double kept(String name, double value) {
        return parameters.contains(name) ? value + 1 : value;
    }

    float keptAltitude(int index, float altitude) {
        return items.contains(index) ? altitude + 5 : altitude;
    }
}
