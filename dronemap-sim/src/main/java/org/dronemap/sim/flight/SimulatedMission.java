package org.dronemap.sim.flight;

import java.util.ArrayList;
import java.util.List;

/** The mission stored in a simulated vehicle; can be overwritten item by item or as a whole. Owned by its vehicle. */
public final class SimulatedMission {
    private final List<SimulatedMissionItem> items = new ArrayList<>();

    public int size() {
        return items.size();
    }

    public SimulatedMissionItem item(int index) {
        return items.get(index);
    }

    public List<SimulatedMissionItem> items() {
        return List.copyOf(items);
    }

    public void truncate(int count) {
        if (count < items.size()) {
            items.subList(count, items.size()).clear();
        }
    }

    /** Replaces an item, or appends the next one. */
    public void put(int index, SimulatedMissionItem item) {
        if (index < items.size()) {
            items.set(index, item);
        } else {
            items.add(item);
        }
    }

    public void replaceAll(List<SimulatedMissionItem> newItems) {
        items.clear();
        items.addAll(newItems);
    }

    public void clear() {
        items.clear();
    }
}
