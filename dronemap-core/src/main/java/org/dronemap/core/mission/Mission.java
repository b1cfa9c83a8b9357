package org.dronemap.core.mission;

import java.util.List;
import org.dronemap.core.stored.Stored;

/** An ordered list of 1 to 500 items that one vehicle flies by itself. */
@Stored(names = "items")
public record Mission(List<MissionItem> items) {
    /** Most items of one mission; real autopilots hold some seven hundred. */
    public static final int MAX_ITEMS = 500;

    public Mission {
        items = List.copyOf(items);
        if (items.isEmpty() || items.size() > MAX_ITEMS) {
            throw new IllegalArgumentException("a mission has 1 to " + MAX_ITEMS + " items, not " + items.size());
        }
        if (items.stream().anyMatch(MissionItem.Other.class::isInstance)) {
            throw new IllegalArgumentException("a mission holds only items that the cloud can plan");
        }
    }
}
