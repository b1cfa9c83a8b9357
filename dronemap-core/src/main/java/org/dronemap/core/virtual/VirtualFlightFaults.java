package org.dronemap.core.virtual;

import java.time.Duration;
import java.util.Optional;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.mission.MissionItem;

/** Reasons for which a drone is called home that is under way on a virtual drone's mission, as sentences. */
final class VirtualFlightFaults {
    /** Who flies a mission moves, except while it waits at a waypoint. */
    private static final Duration LONGEST_STILL = Duration.ofSeconds(30);

    private static final Duration LONGEST_STILL_ON_THE_GROUND = Duration.ofSeconds(6);
    private static final double ON_THE_GROUND_METERS = 1.5;

    private VirtualFlightFaults() {}

    static Optional<String> ofOneUnderWay(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        boolean isSteered = drone.capabilities().steering(drone.mode()).isPresent();
        if (isSteered && !VirtualRunMachine.isOnMission(drone)) {
            return Optional.of("The drone left its mission; it is called home.");
        }
        if (drone.link().trend().isFalling()) {
            return Optional.of(drone.link().trend().words() + " It is called home before that.");
        }
        return isStuck(run, assignment, drone, sight)
                ? Optional.of("The drone does not move on; it is called home.")
                : Optional.empty();
    }

    /** It may have crashed: vehicles do not always notice that themselves. */
    private static boolean isStuck(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        MissionItem.Waypoint next = run.tour().waypoints().get(run.flown());
        Position position = drone.position();
        Double above = position == null ? null : position.altitudeAboveHomeMeters();
        boolean down = assignment.takeOffMeters() != null && above != null && above < ON_THE_GROUND_METERS;
        // It may have set off a moment ago from where it was to wait.
        double waited = run.flown() == 0
                ? 0
                : run.tour().waypoints().get(run.flown() - 1).holdSeconds();
        Duration longest = LONGEST_STILL.plusSeconds(Math.round(next.holdSeconds() + waited));
        // It may have stood there so that another one could pass.
        Duration sent = Duration.between(run.changedAt(), sight.now());
        Duration still = sent.compareTo(sight.still()) < 0 ? sent : sight.still();
        return still.compareTo(down ? LONGEST_STILL_ON_THE_GROUND : longest) > 0;
    }
}
