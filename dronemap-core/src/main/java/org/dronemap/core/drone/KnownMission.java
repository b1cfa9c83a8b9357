package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** The mission last known on board a vehicle and its current item, as stored over restarts. */
public record KnownMission(
        List<MissionItem> items,
        @Nullable String hash,
        @Nullable Integer current) {
    public KnownMission {
        items = List.copyOf(items);
    }

    /** Known by its items alone. */
    public KnownMission(List<MissionItem> items, @Nullable Integer current) {
        this(items, null, current);
    }

    /** The same, whose exact items are known now. */
    public KnownMission withHash(@Nullable String exact) {
        return new KnownMission(items, exact, current);
    }
}
