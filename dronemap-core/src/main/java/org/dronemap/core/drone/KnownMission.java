package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** What the cloud last knew to be on a vehicle, and the index it was heading for then. */
public record KnownMission(
        List<MissionItem> items, @Nullable Integer current) {
    public KnownMission {
        items = List.copyOf(items);
    }
}
