package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.mission.SavedMission;

/** The sort order of the mission library, by name, the same in every kind of store. */
public final class MissionOrdering {
    public static final Comparator<SavedMission> BY_NAME = Comparator.comparing(
                    SavedMission::name, String.CASE_INSENSITIVE_ORDER)
            .thenComparing(SavedMission::name)
            .thenComparing(SavedMission::id);

    private MissionOrdering() {}
}
