package org.dronemap.core.mission;

import java.util.List;
import java.util.Optional;

/** Stores the organisations' mission libraries; every write returns only after it is durable. */
public interface MissionStore {
    /** All saved missions by name. */
    List<SavedMission> missions();

    Optional<SavedMission> mission(String id);

    /** Inserts or replaces. */
    void save(SavedMission mission);

    /** True when there was one. */
    boolean delete(String id);
}
