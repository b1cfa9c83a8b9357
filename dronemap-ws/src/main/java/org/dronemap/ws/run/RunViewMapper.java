package org.dronemap.ws.run;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.ReplanProposal;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunExplanation;
import org.dronemap.cognitive.operation.run.model.RunPool;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.replan.PlanFigures;
import org.dronemap.cognitive.replan.ReassignedWaypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.WaypointTask;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.zone.ZoneFeature;
import org.jspecify.annotations.Nullable;

/** Maps mission runs to what clients see, once for all faces. */
final class RunViewMapper {
    private RunViewMapper() {}

    public static RunView view(Snapshot<RunState> run) {
        SavedOperation saved = run.saved();
        RunState state = run.state();
        ReplanProposal proposal = state.proposal();
        return new RunView(
                saved.id().value(),
                saved.name(),
                saved.owner(),
                millis(saved.beganAt()),
                millisOrNull(saved.endedAt()),
                stateWord(run),
                run.setAside() == null ? state.end() : run.setAside(),
                WireNames.camel(state.setting().mode()),
                state.setting().onCloudLoss() == MissionCloudLossPolicy.CONTINUE ? "continue" : "rtl",
                upTo(state),
                counts(state),
                state.drones().stream().map(drone -> drone(state, drone)).toList(),
                state.targets().stream().map(target -> waypoint(state, target)).toList(),
                state.setting().barriers().stream()
                        .flatMap(barrier -> ZoneFeature.of(barrier).stream())
                        .toList(),
                proposal == null ? null : proposal(proposal),
                state.explanations().stream().map(RunViewMapper::explanation).toList(),
                saved.last());
    }

    private static @Nullable Integer upTo(RunState state) {
        RunPool pool = state.setting().pool();
        return pool == null ? null : (Integer) pool.upTo();
    }

    private static String stateWord(Snapshot<RunState> run) {
        RunState state = run.state();
        if (state.isOver() || run.saved().endedAt() != null) {
            return "over";
        }
        if (run.setAside() != null) {
            return "stopping";
        }
        return state.stopping() ? "stopping" : state.clock().pausedSince() != null ? "paused" : "running";
    }

    private static RunView.CountsView counts(RunState state) {
        return new RunView.CountsView(
                state.targets().size(),
                state.count(RunWaypoint.State.VISITED),
                state.count(RunWaypoint.State.UNSERVED),
                state.count(RunWaypoint.State.CANCELLED),
                state.counts().replans(),
                state.counts().doubles());
    }

    private static RunView.DroneView drone(RunState state, RunDrone drone) {
        int visited = (int) state.targets().stream()
                .filter(target ->
                        target.visits().stream().anyMatch(visit -> visit.drone().equals(drone.id())))
                .count();
        return new RunView.DroneView(
                drone.id().value(),
                drone.name(),
                WireNames.camel(drone.stage()),
                millis(drone.since()),
                drone.note(),
                drone.orders(),
                visited,
                state.due(drone.id()).map(RunViewMapper::millis).orElse(null));
    }

    private static RunView.WaypointView waypoint(RunState state, RunWaypoint target) {
        Place place = target.waypoint().place();
        return new RunView.WaypointView(
                target.id(),
                place.point().latitudeDegrees(),
                place.point().longitudeDegrees(),
                place.altitudeAmslMeters(),
                WireNames.camel(target.state()),
                id(target.drone()),
                target.reason(),
                state.due(target).map(RunViewMapper::millis).orElse(null),
                target.visits().stream()
                        .map(visit -> new RunView.VisitView(visit.drone().value(), millis(visit.at())))
                        .toList(),
                tasks(target));
    }

    private static List<RunView.TaskView> tasks(RunWaypoint target) {
        List<WaypointTask> parts = target.waypoint().task().parts();
        List<RunView.TaskView> tasks = new ArrayList<>();
        for (int part = 0; part < parts.size(); part++) {
            RunWaypoint.Report report = target.report(part).orElse(null);
            tasks.add(
                    report == null
                            ? new RunView.TaskView(type(parts.get(part)), "open", null, null, null, null)
                            : new RunView.TaskView(
                                    type(parts.get(part)),
                                    WireNames.camel(report.result()),
                                    report.drone().value(),
                                    millis(report.at()),
                                    report.photo(),
                                    report.words()));
        }
        return tasks;
    }

    private static String type(WaypointTask task) {
        if (task instanceof WaypointTask.Photo) {
            return "photo";
        }
        if (task instanceof WaypointTask.Servo) {
            return "servo";
        }
        return task instanceof WaypointTask.Look ? "lookAt" : "readSensors";
    }

    private static RunView.ProposalView proposal(ReplanProposal proposal) {
        return new RunView.ProposalView(
                proposal.number(),
                millis(proposal.at()),
                proposal.words(),
                moved(proposal.plan().changes().moved()),
                shown(proposal.plan().before()),
                shown(proposal.plan().after()));
    }

    private static RunView.ExplanationView explanation(RunExplanation explanation) {
        return new RunView.ExplanationView(
                explanation.number(),
                millis(explanation.at()),
                WireNames.camel(explanation.trigger()),
                id(explanation.drone()),
                moved(explanation.moved()),
                figures(explanation.before()),
                figures(explanation.after()),
                explanation.words());
    }

    private static List<RunView.MovedView> moved(List<ReassignedWaypoint> moved) {
        return moved.stream()
                .map(one -> new RunView.MovedView(one.waypoint(), id(one.from()), id(one.to())))
                .toList();
    }

    private static RunView.@Nullable FiguresView figures(@Nullable PlanFigures figures) {
        return figures == null ? null : shown(figures);
    }

    private static RunView.FiguresView shown(PlanFigures figures) {
        return new RunView.FiguresView(figures.longestSeconds(), figures.cost(), figures.unserved());
    }

    private static @Nullable String id(@Nullable DroneId drone) {
        return drone == null ? null : drone.value();
    }

    private static @Nullable Instant millisOrNull(@Nullable Instant time) {
        return time == null ? null : millis(time);
    }

    private static Instant millis(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS);
    }
}
