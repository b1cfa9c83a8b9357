package org.dronemap.sim.flight;

import java.util.ArrayList;
import java.util.List;

/** The mission stored in a simulated vehicle; can be overwritten item by item or as a whole. Owned by its vehicle. */
public final class FlightPlan {
    private final List<StoredMissionItem> items = new ArrayList<>();

    public int size() {
        return items.size();
    }

    public StoredMissionItem item(int index) {
        return items.get(index);
    }

    public List<StoredMissionItem> items() {
        return List.copyOf(items);
    }

    public void truncate(int count) {
        if (count < items.size()) {
            items.subList(count, items.size()).clear();
        }
    }

    /** Replaces an item, or appends the next one. */
    public void put(int index, StoredMissionItem item) {
        if (index < items.size()) {
            items.set(index, item);
        } else {
            items.add(item);
        }
    }

    public void replaceAll(List<StoredMissionItem> newItems) {
        items.clear();
        items.addAll(newItems);
    }

    public void clear() {
        items.clear();
    }
}
