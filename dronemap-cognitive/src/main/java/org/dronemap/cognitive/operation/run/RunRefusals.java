package org.dronemap.cognitive.operation.run;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunObjection;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Objection.Subject;
import org.dronemap.core.operation.OperationObjection;

/** Decides whether a user's request to a mission run is refused now, and for which reason. */
final class RunRefusals {
    private static final int MOST_DRONES = 100;

    private static final int METERS_PER_KM = 1_000;

    private RunRefusals() {}

    private static Optional<Objection> why(RunObjection code, String sentence, Objection.About... about) {
        return Optional.of(Objection.of(code, sentence, about));
    }

    static Optional<Objection> of(RunState state, RunInput input) {
        if (!(input instanceof RunInput.UserRequest)) {
            return Optional.empty();
        }
        if (state.isOver()) {
            return Optional.of(Objection.of(OperationObjection.OVER, "The mission run is over."));
        }
        if (state.stopping()) {
            return why(RunObjection.STOPPING, "The mission run is being stopped.");
        }
        if (input instanceof RunInput.Pause || input instanceof RunInput.Resume) {
            return ofPause(state.clock().pausedSince() != null, input instanceof RunInput.Pause);
        }
        if (input instanceof RunInput.AnswerProposal answer) {
            return state.proposal() != null && state.proposal().number() == answer.proposal()
                    ? Optional.empty()
                    : why(
                            RunObjection.NO_PROPOSAL,
                            "There is no proposal " + answer.proposal() + " that waits for an answer.",
                            Subject.PROPOSAL.is(answer.proposal()));
        }
        return isOfDrone(input) ? ofDrone(state, input) : ofWaypoint(state, input);
    }

    private static boolean isOfDrone(RunInput input) {
        return input instanceof RunInput.JoinDrone
                || input instanceof RunInput.JoinFromPool
                || input instanceof RunInput.ResumeDrone
                || input instanceof RunInput.GiveUpDrone;
    }

    private static Optional<Objection> ofPause(boolean paused, boolean pauses) {
        if (paused != pauses) {
            return Optional.empty();
        }
        return paused
                ? why(RunObjection.PAUSED, "The mission run is paused already.")
                : why(RunObjection.NOT_PAUSED, "The mission run is not paused.");
    }

    private static Optional<Objection> ofDrone(RunState state, RunInput input) {
        if (input instanceof RunInput.JoinDrone join) {
            return joins(state, join.craft());
        }
        if (input instanceof RunInput.JoinFromPool join) {
            return joins(state, join.craft());
        }
        boolean resumes = input instanceof RunInput.ResumeDrone;
        DroneId id =
                input instanceof RunInput.ResumeDrone resume ? resume.drone() : ((RunInput.GiveUpDrone) input).drone();
        Optional<RunDrone> drone = state.drone(id);
        if (drone.isEmpty()) {
            return why(RunObjection.DRONE_NOT_IN_RUN, "The drone is no part of the run.", Subject.DRONE.is(id.value()));
        }
        boolean can = switch (drone.get().stage()) {
            case SUSPENDED -> true;
            case LEFT, GONE -> resumes;
            case CRASHED -> false;
            default -> !resumes;
        };
        if (can) {
            return Optional.empty();
        }
        String name = drone.get().name();
        return resumes
                ? why(
                        drone.get().stage() == RunDroneStage.CRASHED
                                ? RunObjection.DRONE_OUT
                                : RunObjection.DRONE_NOT_RESUMABLE,
                        name + " does not wait for being resumed.",
                        Subject.DRONE.is(id.value()))
                : why(RunObjection.DRONE_OUT, name + " is out of the run already.", Subject.DRONE.is(id.value()));
    }

    private static Optional<Objection> joins(RunState state, Craft craft) {
        boolean there = state.drone(craft.id())
                .filter(drone -> drone.stage() != RunDroneStage.LEFT)
                .isPresent();
        if (there) {
            return why(
                    RunObjection.DRONE_IN_RUN,
                    "The drone is part of the run.",
                    Subject.DRONE.is(craft.id().value()));
        }
        return state.drones().size() >= MOST_DRONES
                ? why(
                        RunObjection.DRONES_FULL,
                        "A run has " + MOST_DRONES + " drones at most.",
                        Subject.MOST.is(MOST_DRONES))
                : near(state, craft.start().place());
    }

    private static Optional<Objection> ofWaypoint(RunState state, RunInput input) {
        if (input instanceof RunInput.AddWaypoints add) {
            return added(state, add.waypoints());
        }
        if (input instanceof RunInput.AddBarrier add) {
            int corners = add.barrier().turns()
                    + state.setting().barriers().stream()
                            .mapToInt(each -> each.turns())
                            .sum();
            return corners > PlanningProblem.MOST_CORNERS
                    ? why(
                            RunObjection.ZONES_FULL,
                            "That is more zones than ways can be found between.",
                            Subject.MOST.is(PlanningProblem.MOST_CORNERS))
                    : Optional.empty();
        }
        String id = input instanceof RunInput.MoveWaypoint move
                ? move.waypoint()
                : input instanceof RunInput.CancelWaypoint cancel ? cancel.waypoint() : null;
        if (id == null) {
            return Optional.empty();
        }
        Optional<RunWaypoint> target = state.target(id);
        if (target.isEmpty()) {
            return why(RunObjection.NO_WAYPOINT, "The run has no waypoint " + id + ".", Subject.WAYPOINT.is(id));
        }
        if (target.get().state().isSettled()) {
            return why(
                    RunObjection.WAYPOINT_SETTLED,
                    "The waypoint " + id + " is settled: " + words(target.get()) + ".",
                    Subject.WAYPOINT.is(id),
                    Subject.STATE.is(target.get().state().name().toLowerCase(Locale.ROOT)));
        }
        return input instanceof RunInput.MoveWaypoint move ? near(state, move.to()) : Optional.empty();
    }

    private static String words(RunWaypoint target) {
        return switch (target.state()) {
            case VISITED -> "visited";
            case CANCELLED -> "cancelled";
            default -> "nobody visits it";
        };
    }

    private static Optional<Objection> added(RunState state, List<Waypoint> waypoints) {
        Set<String> known = new HashSet<>();
        state.targets().forEach(target -> known.add(target.id()));
        if (waypoints.isEmpty() || known.size() + waypoints.size() > PlanningProblem.MOST_WAYPOINTS) {
            return why(
                    RunObjection.WAYPOINTS_FULL,
                    "One waypoint at least is added, and a run has 100000 at most.",
                    Subject.MOST.is(PlanningProblem.MOST_WAYPOINTS));
        }
        for (Waypoint waypoint : waypoints) {
            if (!known.add(waypoint.id())) {
                return why(
                        RunObjection.WAYPOINT_KNOWN,
                        "There is a waypoint " + waypoint.id() + " already.",
                        Subject.WAYPOINT.is(waypoint.id()));
            }
            Optional<Objection> far = near(state, waypoint.place());
            if (far.isPresent()) {
                return far;
            }
        }
        return Optional.empty();
    }

    /** A problem holds only places that are near to each other. */
    private static Optional<Objection> near(RunState state, Place place) {
        Place first = state.drones().get(0).craft().finish().place();
        return Geodesy.distanceMeters(first.point(), place.point()) < PlanningProblem.WIDEST_METERS / 2
                ? Optional.empty()
                : why(
                        RunObjection.TOO_FAR,
                        "That place is more than 100 km away.",
                        Subject.MOST.is((long) PlanningProblem.WIDEST_METERS / 2 / METERS_PER_KM));
    }
}
