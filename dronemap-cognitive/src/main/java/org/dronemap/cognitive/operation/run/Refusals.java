package org.dronemap.cognitive.operation.run;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Problem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodesy;

/** Why a run cannot do now what somebody wants, as sentences. */
final class Refusals {
    private static final int MOST_DRONES = 100;

    private Refusals() {}

    static Optional<String> of(RunState state, RunInput input) {
        if (!(input instanceof RunInput.Wish)) {
            return Optional.empty();
        }
        if (state.isOver()) {
            return Optional.of("The mission run is over.");
        }
        if (state.stopping()) {
            return Optional.of("The mission run is being stopped.");
        }
        if (input instanceof RunInput.Pause || input instanceof RunInput.GoOn) {
            return ofPause(state.clock().pausedSince() != null, input instanceof RunInput.Pause);
        }
        if (input instanceof RunInput.Answer answer) {
            return state.proposal() != null && state.proposal().number() == answer.proposal()
                    ? Optional.empty()
                    : Optional.of("There is no proposal " + answer.proposal() + " that waits for an answer.");
        }
        return input instanceof RunInput.JoinDrone
                        || input instanceof RunInput.ResumeDrone
                        || input instanceof RunInput.GiveUpDrone
                ? ofDrone(state, input)
                : ofWaypoint(state, input);
    }

    private static Optional<String> ofPause(boolean paused, boolean pauses) {
        return paused == pauses
                ? Optional.of(paused ? "The mission run is paused already." : "The mission run is not paused.")
                : Optional.empty();
    }

    private static Optional<String> ofDrone(RunState state, RunInput input) {
        if (input instanceof RunInput.JoinDrone join) {
            return joins(state, join);
        }
        boolean resumes = input instanceof RunInput.ResumeDrone;
        DroneId id =
                input instanceof RunInput.ResumeDrone resume ? resume.drone() : ((RunInput.GiveUpDrone) input).drone();
        Optional<RunDrone> drone = state.drone(id);
        if (drone.isEmpty()) {
            return Optional.of("The drone is no part of the run.");
        }
        boolean can = switch (drone.get().stage()) {
            case SUSPENDED -> true;
            case LEFT, GONE -> resumes;
            case CRASHED -> false;
            default -> !resumes;
        };
        String why = resumes ? " does not wait for being resumed." : " is out of the run already.";
        return can ? Optional.empty() : Optional.of(drone.get().name() + why);
    }

    private static Optional<String> joins(RunState state, RunInput.JoinDrone join) {
        boolean there = state.drone(join.craft().id())
                .filter(drone -> drone.stage() != DroneStage.LEFT)
                .isPresent();
        if (there) {
            return Optional.of("The drone is part of the run.");
        }
        return state.drones().size() >= MOST_DRONES
                ? Optional.of("A run has " + MOST_DRONES + " drones at most.")
                : near(state, join.craft().start().place());
    }

    private static Optional<String> ofWaypoint(RunState state, RunInput input) {
        if (input instanceof RunInput.AddWaypoints add) {
            return added(state, add.waypoints());
        }
        if (input instanceof RunInput.AddBarrier add) {
            int corners = add.barrier().turns()
                    + state.setting().barriers().stream()
                            .mapToInt(each -> each.turns())
                            .sum();
            return corners > Problem.MOST_CORNERS
                    ? Optional.of("That is more zones than ways can be found between.")
                    : Optional.empty();
        }
        String id = input instanceof RunInput.MoveWaypoint move
                ? move.waypoint()
                : input instanceof RunInput.CancelWaypoint cancel ? cancel.waypoint() : null;
        if (id == null) {
            return Optional.empty();
        }
        Optional<Target> target = state.target(id);
        if (target.isEmpty()) {
            return Optional.of("The run has no waypoint " + id + ".");
        }
        if (target.get().state().isSettled()) {
            return Optional.of("The waypoint " + id + " is settled: " + words(target.get()) + ".");
        }
        return input instanceof RunInput.MoveWaypoint move ? near(state, move.to()) : Optional.empty();
    }

    private static String words(Target target) {
        return switch (target.state()) {
            case VISITED -> "visited";
            case CANCELLED -> "cancelled";
            default -> "nobody visits it";
        };
    }

    private static Optional<String> added(RunState state, List<Waypoint> waypoints) {
        Set<String> known = new HashSet<>();
        state.targets().forEach(target -> known.add(target.id()));
        if (waypoints.isEmpty() || known.size() + waypoints.size() > Problem.MOST_WAYPOINTS) {
            return Optional.of("One waypoint at least is added, and a run has 100000 at most.");
        }
        for (Waypoint waypoint : waypoints) {
            if (!known.add(waypoint.id())) {
                return Optional.of("There is a waypoint " + waypoint.id() + " already.");
            }
            Optional<String> far = near(state, waypoint.place());
            if (far.isPresent()) {
                return far;
            }
        }
        return Optional.empty();
    }

    /** A problem holds only places that are near to each other. */
    private static Optional<String> near(RunState state, Place place) {
        Place first = state.drones().get(0).craft().finish().place();
        return Geodesy.distanceMeters(first.point(), place.point()) < Problem.WIDEST_METERS / 2
                ? Optional.empty()
                : Optional.of("That place is more than 100 km away.");
    }
}
