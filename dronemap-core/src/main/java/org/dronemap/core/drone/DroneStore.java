package org.dronemap.core.drone;

import java.util.List;
import java.util.Optional;

/** Stores drones and the mission last known on board each; every write returns only after it is durable. */
public interface DroneStore {
    List<DroneRecord> drones();

    /** Inserts or replaces. */
    void save(DroneRecord drone);

    /** Forgets the drone and what hangs on it; its commands stay in the log. */
    void delete(DroneId id);

    /** What the cloud last knew to be on the vehicle; empty when nothing is known. */
    Optional<KnownMission> knownMission(DroneId id);

    void saveKnownMission(DroneId id, KnownMission mission);
}
