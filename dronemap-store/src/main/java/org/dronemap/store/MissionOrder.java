package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.mission.SavedMission;

/** How the mission library is listed, in every adapter alike. */
public final class MissionOrder {
    public static final Comparator<SavedMission> BY_NAME = Comparator.comparing(
                    SavedMission::name, String.CASE_INSENSITIVE_ORDER)
            .thenComparing(SavedMission::name)
            .thenComparing(SavedMission::id);

    private MissionOrder() {}
}
