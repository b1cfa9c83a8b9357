package org.dronemap.cognitive.operation.run;

import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionComparison;
import org.dronemap.core.operation.OperationObservation;
import org.jspecify.annotations.Nullable;

/** Builds a mission run's observations of its drones from their live states. */
final class RunObservations {
    private RunObservations() {}

    static RunInput of(RunState state, OperationObservation scene) {
        List<DroneObservation> looks = state.drones().stream()
                .flatMap(drone -> scene.of(drone.id()).map(seen -> look(drone, seen)).stream())
                .toList();
        return new RunInput.Observed(scene.now(), looks);
    }

    private static DroneObservation look(RunDrone drone, OperationObservation.ObservedDrone seen) {
        DroneState state = seen.state();
        Capabilities can = state.capabilities();
        Position position = state.position();
        Motion motion = state.motion();
        Attitude attitude = state.attitude();
        Battery battery = state.battery();
        return new DroneObservation(
                drone.id(),
                seen.whyNotCommandable(),
                state.link().state(),
                seen.silence(),
                seen.still(),
                can.known(),
                state.mode(),
                ordersMode(state).orElse(null),
                can.steering(state.mode()).orElse(null),
                state.armed(),
                state.airborne(),
                place(state, position, drone),
                position == null ? null : position.altitudeAboveHomeMeters(),
                motion == null ? null : motion.climbRate(),
                motion == null ? null : motion.groundSpeed(),
                attitude == null
                        ? null
                        : Double.valueOf(Math.max(Math.abs(attitude.rollDegrees()), Math.abs(attitude.pitchDegrees()))),
                battery == null ? null : battery.percent(),
                can.commands().contains(Capability.GO_TO),
                can.commands().contains(Capability.RETURN_TO_LAUNCH),
                state.returnHeight(),
                progress(drone, state),
                payload(drone.sortie(), state),
                seen.control().transfer(),
                seen.giveWay(),
                state.link().trend().isFalling() ? state.link().trend().words() : null);
    }

    private static PayloadState payload(@Nullable Sortie sortie, DroneState state) {
        return sortie == null || sortie.tasks().isEmpty() ? PayloadState.UNKNOWN : state.payload();
    }

    /** The mode in which it can be armed; empty when it is in one. */
    private static Optional<String> ordersMode(DroneState state) {
        Capabilities can = state.capabilities();
        return can.steering(state.mode()).equals(Optional.of(Steering.ORDERS))
                ? Optional.empty()
                : can.mode(Steering.ORDERS);
    }

    private static @Nullable Place place(DroneState state, @Nullable Position position, RunDrone drone) {
        if (position == null || position.point() == null) {
            return null;
        }
        Home home = state.home();
        double homeMeters = home == null ? drone.craft().homeAmslMeters() : home.altitudeAmslMeters();
        Double above = position.altitudeAboveHomeMeters();
        // Height above home is what the vehicle flies by; the satellites' own is metres off.
        Double meters = above == null ? position.altitudeAmslMeters() : Double.valueOf(homeMeters + above);
        return meters == null || meters < Altitude.LOWEST_PLANNED_METERS || meters > Altitude.HIGHEST_PLANNED_METERS
                ? null
                : new Place(position.point(), meters);
    }

    private static DroneObservation.Progress progress(RunDrone drone, DroneState state) {
        MissionProgress mission = state.mission();
        int passed =
                mission.reached().stream().mapToInt(index -> index + 1).max().orElse(0);
        Boolean carries = carries(drone.sortie(), mission);
        if (mission.current() != null && mission.phase() != MissionPhase.COMPLETE && isBegun(state, drone, carries)) {
            passed = Math.max(passed, mission.current());
        }
        return new DroneObservation.Progress(
                carries,
                carries(drone.next(), mission),
                mission.items() != null && (mission.current() != null || mission.phase() != null),
                passed,
                mission.complete(),
                fault(drone.next(), state));
    }

    private static DroneObservation.@Nullable ItemFault fault(@Nullable Sortie next, DroneState state) {
        if (next == null) {
            return null;
        }
        return state.capabilities()
                .missions()
                .fault(next.mission())
                .map(fault -> new DroneObservation.ItemFault(
                        fault.index(),
                        fault.sentence(next.mission(), state.identification().vehicle())))
                .orElse(null);
    }

    /** A mission that was brought to it and not started yet keeps the place where it was in the one before. */
    private static boolean isBegun(DroneState state, RunDrone drone, @Nullable Boolean carries) {
        return (Boolean.TRUE.equals(carries) && drone.flags().begun())
                || !state.mission().reached().isEmpty()
                || state.capabilities().steering(state.mode()).equals(Optional.of(Steering.MISSION));
    }

    private static @Nullable Boolean carries(@Nullable Sortie sortie, MissionProgress mission) {
        if (sortie == null || mission.items() == null) {
            return null;
        }
        return MissionComparison.difference(sortie.mission().items(), mission.items())
                .isEmpty();
    }
}
