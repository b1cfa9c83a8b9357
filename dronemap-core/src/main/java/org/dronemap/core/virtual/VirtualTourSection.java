package org.dronemap.core.virtual;

import java.util.Optional;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionComparison;

/**
 * The part of a virtual drone's tour that one real drone is given to fly.
 *
 * @param first the tour's waypoint that it begins with, counted from 0
 * @param lead items before that one
 */
public record VirtualTourSection(Mission mission, int first, int lead) {
    /** Whether this is what the vehicle carries; empty when it is not known what it carries. */
    Optional<Boolean> isOnBoard(MissionProgress progress) {
        return Optional.ofNullable(progress.items())
                .map(items ->
                        MissionComparison.difference(mission.items(), items).isEmpty());
    }

    /** How many waypoints of the tour are behind it, by what the vehicle says; never less than it began with. */
    int flown(MissionProgress progress) {
        int passed =
                progress.reached().stream().mapToInt(index -> index + 1).max().orElse(0);
        if (progress.phase() == MissionPhase.RUNNING && progress.current() != null) {
            passed = Math.max(passed, progress.current());
        }
        return Math.max(first, Math.min(end(), first + passed - lead));
    }

    /** How many waypoints of the tour are behind it when all of it is flown. */
    int end() {
        return first + mission.items().size() - lead - 1;
    }
}
