package org.dronemap.store.memory;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.mission.SavedMission;
import org.dronemap.store.MissionOrdering;
import org.dronemap.store.StoredInstant;

/** Keeps the mission library in memory, for tests. Thread-safe: every method holds the object's lock. */
public final class MemoryMissionStore implements MissionStore {
    private final Map<String, SavedMission> missions = new HashMap<>();

    @Override
    public synchronized List<SavedMission> missions() {
        return missions.values().stream().sorted(MissionOrdering.BY_NAME).toList();
    }

    @Override
    public synchronized Optional<SavedMission> mission(String id) {
        return Optional.ofNullable(missions.get(id));
    }

    @Override
    public synchronized void save(SavedMission mission) {
        missions.put(
                mission.id(),
                new SavedMission(
                        mission.id(),
                        mission.name(),
                        mission.mission(),
                        mission.changedBy(),
                        StoredInstant.of(mission.changedAt()),
                        mission.organisation()));
    }

    @Override
    public synchronized boolean delete(String id) {
        return missions.remove(id) != null;
    }
}
