package org.dronemap.core.virtual;

import static org.dronemap.core.virtual.VirtualRunStage.ARMING;
import static org.dronemap.core.virtual.VirtualRunStage.DONE;
import static org.dronemap.core.virtual.VirtualRunStage.RETURNING;
import static org.dronemap.core.virtual.VirtualRunStage.STOPPED;
import static org.dronemap.core.virtual.VirtualRunStage.STOPPING;
import static org.dronemap.core.virtual.VirtualRunStep.Release.FREE;
import static org.dronemap.core.virtual.VirtualRunStep.Release.RECALL;

import java.time.Duration;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;

/** Decides the next step of a virtual drone's run while its real drone is out of contact. */
final class SilentVirtualRunRules {
    /** On the ground a drone that is not heard is soon replaced. */
    private static final Duration PATIENCE_ON_THE_GROUND = Duration.ofSeconds(15);

    private final Duration silence;

    /** {@code silence}: so long a drone that is not heard counts as flying, beside what its mission still takes. */
    SilentVirtualRunRules(Duration silence) {
        this.silence = silence;
    }

    /** A silent drone is still flying: what was given to it stays its own until it must be down. */
    VirtualRunStep next(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        boolean neverArmed = run.stage().compareTo(ARMING) <= 0 && !Boolean.TRUE.equals(drone.armed());
        Duration patience = neverArmed ? PATIENCE_ON_THE_GROUND : silence.plus(remaining(run, drone));
        if (sight.silence().compareTo(patience) <= 0) {
            String words = neverArmed
                    ? "Nothing is heard of the drone."
                    : "Nothing is heard of the drone; it may still "
                            + (drone.identification().kind().neverFlies() ? "be under way" : "fly")
                            + ", and its waypoints stay its own.";
            return VirtualRunStep.unchanged(run.withNote(words, sight.now()));
        }
        VirtualRunStep.Release release = neverArmed ? FREE : RECALL;
        return switch (run.stage()) {
            case RETURNING ->
                VirtualRunStep.leave(
                        run.unbound(
                                DONE,
                                "All waypoints are flown; the drone was not heard again on its way back.",
                                null,
                                sight.now()),
                        release);
            case STOPPING ->
                VirtualRunStep.leave(
                        run.unbound(
                                STOPPED, "It was stopped; the drone was not heard again.", run.detail(), sight.now()),
                        release);
            default -> VirtualRunMachine.replace(run, assignment, "The drone was not heard again.", sight, release);
        };
    }

    /** What the mission may still take where a silent drone flies it to the end. */
    private static Duration remaining(VirtualRun run, DroneState drone) {
        Position position = drone.position();
        Geodetic at = position == null ? null : position.point();
        if (run.onCloudLoss() != MissionCloudLossPolicy.CONTINUE || at == null) {
            return Duration.ZERO;
        }
        int next = Math.min(run.flown(), run.total() - 1);
        return Duration.ofSeconds(Math.round(
                TourEnergyEstimate.of(run.tour(), next, drone, at, null).minutes() * 60));
    }
}
